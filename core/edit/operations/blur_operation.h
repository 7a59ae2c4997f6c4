#pragma once

#include <algorithm>

#include "core/edit/fields/field.h"
#include "core/edit/operations/beta_row.h"
#include "core/edit/operations/operation_info.h"

namespace swaplight {

/// The radius of edits that look around a pixel.
inline constexpr Scale kRadiusScale{Scale::Unit::Pixels, 1, 256, 1, 256};

/// beta blurred by a Gaussian of sigma = radius / 2; pixels without light do not take part.
struct BlurOperation {
  int radius = 8;  ///< pixels, 1..256
  bool operator==(const BlurOperation&) const = default;

  static constexpr OperationInfo info{"blur", "Blur", "Softens the light's edges and shadows."};
  static constexpr auto fields() {
    return std::tuple{numberField("radius", &BlurOperation::radius, kRadiusScale, "Radius",
                                  "How far it spreads, in image pixels.")};
  }
  [[nodiscard]] int reach() const { return radius; }

  void targetRow(const BetaRow& row, float* target) const {
    std::copy_n(row.blurred, row.beta.size(), target);
  }
};

}  // namespace swaplight
