#pragma once

#include <memory>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/edit/fields/field.h"
#include "core/edit/shapes/shape_info.h"

namespace swaplight {

class JsonFields;
struct SelectionPart;

/// Parts that are put together, one after the other, and softened: what has been selected.
struct SelectionShape {
  std::shared_ptr<const std::vector<SelectionPart>> parts;  ///< never nullptr in a mask
  float feather = 0;
  bool operator==(const SelectionShape& other) const;

  static constexpr ShapeInfo info{"selection", "selection"};
  static constexpr auto fields() { return std::tuple{numberField("feather", &SelectionShape::feather, {})}; }
  void writeMore(Json& json) const;
  void readMore(JsonFields& fields, int width, int height);
};

}  // namespace swaplight
