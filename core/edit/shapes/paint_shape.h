#pragma once

#include <memory>

#include "core/base/json_fwd.h"
#include "core/edit/fields/field.h"
#include "core/edit/shapes/paint.h"
#include "core/edit/shapes/shape_info.h"

namespace swaplight {

class JsonFields;

/// What the brush has left.
struct PaintShape {
  std::shared_ptr<const Painting> painting;
  bool operator==(const PaintShape& other) const;

  static constexpr ShapeInfo info{"painted", "painted"};
  static constexpr auto fields() { return std::tuple{}; }
  void writeMore(Json& json) const;
  /// Paints the strokes again in a picture of this size.
  void readMore(JsonFields& fields, int width, int height);
};

}  // namespace swaplight
