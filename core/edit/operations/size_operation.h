#pragma once

#include <fmt/core.h>

#include <string>

#include "core/edit/fields/field.h"
#include "core/edit/operations/operation_info.h"
#include "core/edit/pool/lamp_change.h"

namespace swaplight {

/// The light's lamp larger or smaller, of the same power: the edges of its shadows, and how its light falls
/// off. Acts on the light's contribution and always adds: see edit/pool/lamp_gain.h and
/// edit/pool/penumbra_scales.h.
struct SizeOperation {
  float times = 1;     ///< the lamp's diameter
  float diameter = 0;  ///< what it was, over its distance from what it lights; 0: not known
  bool operator==(const SizeOperation&) const = default;

  static constexpr OperationInfo info{
      "size", "Size of the lamp",
      "Makes the lamp larger or smaller, with the same power: a larger softbox has softer shadows and lights "
      "less from afar. Highlights and the edge of a spot's cone stay as they are. Of spots it is no better "
      "than nothing: made for softboxes."};
  static constexpr bool kUsesShadows = true;
  static constexpr auto fields() {
    return std::tuple{
        numberField("times", &SizeOperation::times, {Scale::Unit::Factor, .25, 8, .25F, 8}, "Size",
                    "Times the lamp's diameter: above 1 shadows get softer, below 1 harder."),
        numberField(
            "diameter", &SizeOperation::diameter, {Scale::Unit::Percent, 0, 4, 0, 1, "not known"}, "It was",
            "The lamp's diameter when the set was photographed, in per cent of its distance from what "
            "it lights: 50 % is a softbox of 1 m, 2 m away. 0 %: not known; taken for 15 %, or 1 % "
            "where the light makes a cone.")};
  }
  [[nodiscard]] std::string summary() const { return fmt::format("x {:.2f}", times); }
  [[nodiscard]] LampChange lampChange() const {
    LampChange change;
    change.size = times;
    change.diameter = diameter;
    return change;
  }
};

}  // namespace swaplight
