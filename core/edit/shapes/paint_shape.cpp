#include "core/edit/shapes/paint_shape.h"

#include <algorithm>
#include <string>

#include "core/base/json.h"
#include "core/file/json_fields.h"

namespace swaplight {

bool PaintShape::operator==(const PaintShape& other) const {
  if (painting == other.painting) return true;
  if (!painting || !other.painting) return false;
  const auto& a = painting->strokes();
  const auto& b = other.painting->strokes();
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x == y || *x == *y; });
}

void PaintShape::writeMore(Json& json) const {
  Json& strokes = json["strokes"] = Json::array();
  for (const auto& stroke : painting->strokes()) strokes.push_back(jsonFromStroke(*stroke));
}

void PaintShape::readMore(JsonFields& fields, int width, int height) {
  Painting replayed(width, height);
  for (const Json& stroke : fields.list("strokes", "a list of strokes"))
    replayed.begin(
        strokeFromJson(stroke, fields.where() + ": stroke " + std::to_string(replayed.strokes().size() + 1)));
  painting = std::make_shared<const Painting>(std::move(replayed));
}

}  // namespace swaplight
