#pragma once

#include "core/edit/fields/field.h"
#include "core/edit/operations/beta_row.h"
#include "core/edit/operations/operation_info.h"

namespace swaplight {

/// beta = 1 - beta. Of exactly two lights: they change places, each keeping its colour.
struct InvertOperation {
  bool operator==(const InvertOperation&) const = default;

  static constexpr OperationInfo info{
      "invert", "Invert",
      "The light goes where it was not, and leaves where it was. Two lights change places."};
  static constexpr auto fields() { return std::tuple{}; }
  static constexpr bool kSwapsTwoLights = true;

  void targetRow(const BetaRow& row, float* target) const {
    for (size_t i = 0; i < row.beta.size(); ++i) target[i] = 1 - row.beta[i];
  }
};

}  // namespace swaplight
