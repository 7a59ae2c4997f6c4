#pragma once

#include <algorithm>

#include "core/base/curve.h"
#include "core/edit/fields/field.h"
#include "core/edit/operations/beta_row.h"
#include "core/edit/operations/operation_info.h"

namespace swaplight {

/// beta = curve(beta): monotone cubic pieces through the points (Fritsch and Carlson 1980), constant beyond
/// them. x ascending within 0..1, y in 0..4.
struct CurveOperation {
  PointList points = {{0, 0}, {1, 1}};
  bool operator==(const CurveOperation&) const = default;

  static constexpr OperationInfo info{"curve", "Curve",
                                      "Reshapes the light's falloff: less where there is little, more where "
                                      "there is much, or as you draw it."};
  static constexpr auto fields() {
    return std::tuple{plainField("points", &CurveOperation::points, "Curve")};
  }

  /// The curve for beta 0..1 in even steps. Throws InputError where it is none.
  [[nodiscard]] std::vector<float> tabulate() const { return curveTable(points, 1025); }

  void targetRow(const BetaRow& row, float* target) const {
    std::transform(row.beta.begin(), row.beta.end(), target,
                   [&](float beta) { return curveAt(row.table, beta); });
  }
};

}  // namespace swaplight
