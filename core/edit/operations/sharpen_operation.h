#pragma once

#include "core/edit/operations/blur_operation.h"

namespace swaplight {

/// beta + amount * (beta - blurred beta).
struct SharpenOperation {
  int radius = 8;  ///< pixels, 1..256
  float amount = 1;
  bool operator==(const SharpenOperation&) const = default;

  static constexpr OperationInfo info{"sharpen", "Sharpen", "Hardens the light's edges and shadows."};
  static constexpr auto fields() {
    return std::tuple{numberField("radius", &SharpenOperation::radius, kRadiusScale, "Radius",
                                  "Size of the detail that is sharpened, in image pixels."),
                      numberField("amount", &SharpenOperation::amount, {Scale::Unit::Percent, 0, 100, 0, 4},
                                  "Amount", "How much the detail is strengthened.")};
  }
  [[nodiscard]] int reach() const { return radius; }

  void targetRow(const BetaRow& row, float* target) const {
    for (size_t i = 0; i < row.beta.size(); ++i)
      target[i] = row.beta[i] + amount * (row.beta[i] - row.blurred[i]);
  }
};

}  // namespace swaplight
