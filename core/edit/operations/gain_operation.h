#pragma once

#include <fmt/core.h>

#include <string>

#include "core/edit/fields/field.h"
#include "core/edit/operations/beta_row.h"
#include "core/edit/operations/operation_info.h"

namespace swaplight {

/// beta = gain * beta + offset.
struct GainOperation {
  float gain = 1;
  float offset = 0;
  bool operator==(const GainOperation&) const = default;

  static constexpr OperationInfo info{"gain", "Gain and offset",
                                      "Multiplies the light's share by a number and adds another."};
  static constexpr auto fields() {
    return std::tuple{numberField("gain", &GainOperation::gain, {Scale::Unit::Factor, 0, 1e4, 0, 4}, "Gain",
                                  "Multiplies beta, the light's share of the pixel."),
                      numberField("offset", &GainOperation::offset, {Scale::Unit::Percent, -100, 100, -1, 1},
                                  "Offset", "Added to beta.")};
  }
  [[nodiscard]] std::string summary() const {
    return gain == 1 ? fmt::format("{:+.0f} %", 100 * offset) : info.name;
  }

  void targetRow(const BetaRow& row, float* target) const {
    for (size_t i = 0; i < row.beta.size(); ++i) target[i] = gain * row.beta[i] + offset;
  }
};

}  // namespace swaplight
