#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "core/edit/fields/field.h"
#include "core/edit/operations/beta_row.h"
#include "core/edit/operations/operation_info.h"

namespace swaplight {

/// beta = value. 0 takes the light away.
struct FillOperation {
  float value = 1;
  bool operator==(const FillOperation&) const = default;

  static constexpr OperationInfo info{"fill", "Fill",
                                      "Gives the light the same share of every pixel; 0 % removes it."};
  static constexpr auto fields() {
    return std::tuple{
        numberField("value", &FillOperation::value, {Scale::Unit::Percent, 0, 100, 0, 2}, "Beta",
                    "The light's share of each pixel with every light at unit white; 0 % removes "
                    "the light.")};
  }
  static FillOperation initial() { return {.5F}; }
  [[nodiscard]] std::string summary() const {
    return value == 0 ? "none" : fmt::format("to {:.0f} %", 100 * value);
  }

  void targetRow(const BetaRow& row, float* target) const { std::fill_n(target, row.beta.size(), value); }
};

}  // namespace swaplight
