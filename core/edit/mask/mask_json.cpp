#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/edit/mask/mask.h"
#include "core/file/json_fields.h"
#include "core/file/json_file.h"

namespace swaplight {
namespace {

// Each shape's numbers are named once, for both directions.
template <typename Shape, typename Visit>
void visitNumbers(Shape& s, const Visit& visit) {
  using T = std::remove_const_t<Shape>;
  if constexpr (std::is_same_v<T, RectangleShape>) {
    visit("x", s.x), visit("y", s.y), visit("width", s.width), visit("height", s.height),
        visit("feather", s.feather);
  } else if constexpr (std::is_same_v<T, EllipseShape>) {
    visit("x", s.x), visit("y", s.y), visit("radius_x", s.radiusX), visit("radius_y", s.radiusY);
    visit("feather", s.feather);
  } else if constexpr (std::is_same_v<T, PolygonShape> || std::is_same_v<T, SelectionShape>) {
    visit("feather", s.feather);
  } else if constexpr (std::is_same_v<T, LinearGradientShape>) {
    visit("x0", s.x0), visit("y0", s.y0), visit("x1", s.x1), visit("y1", s.y1);
  } else if constexpr (std::is_same_v<T, RadialGradientShape>) {
    visit("x", s.x), visit("y", s.y), visit("inner", s.inner), visit("outer", s.outer);
  } else if constexpr (std::is_same_v<T, PatternShape>) {
    visit("size", s.size), visit("angle", s.angle), visit("cover", s.cover), visit("feather", s.feather);
  } else if constexpr (std::is_same_v<T, TextShape>) {
    visit("x", s.x), visit("y", s.y), visit("height", s.height), visit("feather", s.feather);
  } else if constexpr (std::is_same_v<T, PictureShape>) {
    visit("x", s.x), visit("y", s.y), visit("width", s.width), visit("height", s.height);
  } else if constexpr (std::is_same_v<T, SimilarShape>) {
    visit("tolerance", s.tolerance);
  }
}

constexpr const char* kShapeNames[] = {"rectangle", "ellipse", "polygon", "linear", "radial",  "pattern",
                                       "text",      "picture", "painted", "shadow", "similar", "selection"};
constexpr const char* kLikenessNames[] = {"color", "share"};
constexpr const char* kCombineNames[] = {"add", "subtract", "intersect"};
constexpr const char* kPatternNames[] = {"stripes", "checks", "dots"};

Json jsonFromShape(const MaskShape& shape) {
  Json json = {{"shape", kShapeNames[shape.shape.index()]}};
  std::visit(
      [&](const auto& s) {
        using T = std::decay_t<decltype(s)>;
        visitNumbers(s, [&](const char* key, const float& value) { json[key] = jsonNumber(value); });
        if constexpr (std::is_same_v<T, PolygonShape>) {
          Json& points = json["points"] = Json::array();
          for (const auto& p : s.points) points.push_back({jsonNumber(p[0]), jsonNumber(p[1])});
        } else if constexpr (std::is_same_v<T, PatternShape>) {
          json["kind"] = kPatternNames[static_cast<size_t>(s.kind)];
        } else if constexpr (std::is_same_v<T, TextShape>) {
          json["text"] = s.text;
        } else if constexpr (std::is_same_v<T, PictureShape>) {
          json["file"] = s.file;
        } else if constexpr (std::is_same_v<T, PaintShape>) {
          Json& strokes = json["strokes"] = Json::array();
          for (const auto& stroke : s.painting->strokes()) strokes.push_back(jsonFromStroke(*stroke));
        } else if constexpr (std::is_same_v<T, ShadowShape>) {
          json["light"] = s.light;
          if (s.region) json["at"] = {s.x, s.y};
        } else if constexpr (std::is_same_v<T, SimilarShape>) {
          json["by"] = kLikenessNames[static_cast<size_t>(s.by)];
          json["at"] = {s.x, s.y};
          json["connected"] = s.connected;
        } else if constexpr (std::is_same_v<T, SelectionShape>) {
          Json& parts = json["parts"] = Json::array();
          for (const SelectionPart& part : *s.parts)
            parts.emplace_back(jsonFromShape(part.shape))["combine"] =
                kCombineNames[static_cast<size_t>(part.how)];
        }
      },
      shape.shape);
  if (shape.invert) json["invert"] = true;
  return json;
}

// The place of a word in a list of words.
template <size_t N>
size_t wordFromJson(JsonFields& fields, const char* key, const char* const (&words)[N]) {
  const std::string word = fields.text(key).value_or(words[0]);
  const auto* found = std::find(std::begin(words), std::end(words), word);
  if (found == std::end(words))
    throw InputError("{}: \"{}\" is \"{}\", expected one of {}.", fields.where(), key, word,
                     fmt::join(words, ", "));
  return static_cast<size_t>(found - std::begin(words));
}

MaskShape shapeFromFields(JsonFields& fields, int width, int height);

SelectionPart partFromJson(const Json& json, int width, int height, const std::string& where) {
  JsonFields fields(json, where);
  SelectionPart part{shapeFromFields(fields, width, height), {}};
  if (std::holds_alternative<PaintShape>(part.shape.shape) ||
      std::holds_alternative<PictureShape>(part.shape.shape))
    throw InputError("{}: what is painted and pictures cannot be parts of a selection.", where);
  part.how = static_cast<SelectionPart::Combine>(wordFromJson(fields, "combine", kCombineNames));
  return part;
}

// A pair of numbers [x, y].
std::array<float, 2> pairFromJson(const Json& json, const std::string& where) {
  if (!json.is_array() || json.size() != 2 || !json[0].is_number() || !json[1].is_number())
    throw InputError("{}: found {}, expected [x, y].", where, describeJson(json));
  return {json[0].get<float>(), json[1].get<float>()};
}

template <typename T>
T shapeFromJson(JsonFields& fields, int width, int height) {
  T s;
  visitNumbers(s, [&](const char* key, float& value) {
    value = static_cast<float>(fields.number(key, -1e6, 1e6).value_or(value));
  });
  if constexpr (std::is_same_v<T, PolygonShape>) {
    for (const Json& p : fields.list("points", "a list of [x, y]"))
      s.points.push_back(pairFromJson(p, fields.where() + ": points"));
  } else if constexpr (std::is_same_v<T, PatternShape>) {
    s.kind = static_cast<PatternShape::Kind>(wordFromJson(fields, "kind", kPatternNames));
    if (!(s.size > 0)) throw InputError("{}: \"size\" is {}, expected more than 0.", fields.where(), s.size);
  } else if constexpr (std::is_same_v<T, TextShape>) {
    s.text = fields.text("text").value_or("");
  } else if constexpr (std::is_same_v<T, PictureShape>) {
    s.file = fields.text("file").value_or("");
  } else if constexpr (std::is_same_v<T, PaintShape>) {
    Painting painting(width, height);
    for (const Json& stroke : fields.list("strokes", "a list of strokes"))
      painting.begin(strokeFromJson(
          stroke, fields.where() + ": stroke " + std::to_string(painting.strokes().size() + 1)));
    s.painting = std::make_shared<const Painting>(std::move(painting));
  } else if constexpr (std::is_same_v<T, ShadowShape>) {
    s.light = fields.text("light").value_or("");
    if (const Json* at = fields.find("at")) {
      const auto pixel = pairFromJson(*at, fields.where() + ": at");
      s.region = true;
      s.x = static_cast<int>(pixel[0]);
      s.y = static_cast<int>(pixel[1]);
    }
  } else if constexpr (std::is_same_v<T, SimilarShape>) {
    s.by = static_cast<SimilarShape::By>(wordFromJson(fields, "by", kLikenessNames));
    const Json* at = fields.find("at");
    if (!at) throw InputError("{}: \"at\" is missing, expected [x, y].", fields.where());
    const auto pixel = pairFromJson(*at, fields.where() + ": at");
    s.x = static_cast<int>(pixel[0]);
    s.y = static_cast<int>(pixel[1]);
    s.connected = fields.boolean("connected").value_or(true);
  } else if constexpr (std::is_same_v<T, SelectionShape>) {
    std::vector<SelectionPart> parts;
    for (const Json& part : fields.list("parts", "a list of shapes"))
      parts.push_back(
          partFromJson(part, width, height, fields.where() + ": part " + std::to_string(parts.size() + 1)));
    s.parts = std::make_shared<const std::vector<SelectionPart>>(std::move(parts));
  }
  return s;
}

// The alternative of the variant whose name it is.
template <size_t I = 0>
void readShape(size_t index, MaskShape& out, JsonFields& fields, int width, int height) {
  if constexpr (I < std::variant_size_v<decltype(MaskShape::shape)>) {
    if (index == I)
      out.shape =
          shapeFromJson<std::variant_alternative_t<I, decltype(MaskShape::shape)>>(fields, width, height);
    else
      readShape<I + 1>(index, out, fields, width, height);
  }
}

MaskShape shapeFromFields(JsonFields& fields, int width, int height) {
  const std::string name = fields.text("shape").value_or("");
  const auto* found = std::find(std::begin(kShapeNames), std::end(kShapeNames), name);
  if (found == std::end(kShapeNames))
    throw InputError("{}: \"{}\" is no shape, expected one of {}.", fields.where(), name,
                     fmt::join(kShapeNames, ", "));
  MaskShape shape;
  readShape(static_cast<size_t>(found - kShapeNames), shape, fields, width, height);
  shape.invert = fields.boolean("invert").value_or(false);
  return shape;
}

}  // namespace

bool PaintShape::operator==(const PaintShape& other) const {
  if (painting == other.painting) return true;
  if (!painting || !other.painting) return false;
  const auto& a = painting->strokes();
  const auto& b = other.painting->strokes();
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x == y || *x == *y; });
}

Json jsonFromMask(const Mask& mask) {
  Json json = Json::array();
  for (const MaskShape& shape : mask) json.push_back(jsonFromShape(shape));
  return json;
}

Mask maskFromJson(const Json& json, int width, int height, const std::string& where) {
  if (!json.is_array()) throw InputError("{}: is {}, expected a list of shapes.", where, describeJson(json));
  Mask mask;
  for (const Json& item : json) {
    JsonFields fields(item, where + ": shape " + std::to_string(mask.size() + 1));
    mask.push_back(shapeFromFields(fields, width, height));
  }
  return mask;
}

}  // namespace swaplight
