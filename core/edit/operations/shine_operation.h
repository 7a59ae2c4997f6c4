#pragma once

#include <fmt/core.h>

#include <string>

#include "core/edit/fields/field.h"
#include "core/edit/operations/operation_info.h"

namespace swaplight {

/// The light's highlights, of sets that know them (SolvedSet::highlights): T' = T + (amount - 1) highlight.
/// Acts on the light's contribution, and always adds; edits before it take the highlights along as a part of
/// the light.
struct ShineOperation {
  float amount = 1;  ///< times the highlight, 0..3: 0 is a matte surface, 1 as photographed
  bool operator==(const ShineOperation&) const = default;

  static constexpr OperationInfo info{
      "shine", "Shine", "Makes the light's highlights stronger or weaker, down to a matte surface."};
  static constexpr auto fields() {
    return std::tuple{numberField("amount", &ShineOperation::amount, {Scale::Unit::Factor, 0, 3, 0, 3},
                                  "Shine", "Times the highlight: 0 is matte, 1 as photographed.")};
  }
  [[nodiscard]] std::string summary() const { return fmt::format("x {:.2f}", amount); }
  [[nodiscard]] float highlightTimes() const { return amount; }
};

}  // namespace swaplight
