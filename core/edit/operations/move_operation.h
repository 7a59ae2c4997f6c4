#pragma once

#include <fmt/core.h>

#include <string>

#include "core/edit/fields/field.h"
#include "core/edit/operations/operation_info.h"
#include "core/edit/pool/lamp_handle.h"

namespace swaplight {

/// The light's lamp moved sideways, up and down, nearer or farther, keeping its direction and power. Acts on
/// the light's contribution and always adds: see edit/pool/lamp_gain.h.
struct MoveOperation {
  float right = 0;     ///< widths of the picture
  float up = 0;        ///< widths of the picture
  float distance = 1;  ///< times the distance
  bool operator==(const MoveOperation&) const = default;

  static constexpr OperationInfo info{
      "move", "Move the lamp",
      "Moves the light as if its lamp had stood elsewhere. Its shadows keep their shape, and where the lamp "
      "never shone "
      "the light is a guess: good for about a quarter of the lit area's width."};
  static constexpr Scale kWidths{Scale::Unit::Percent, -2, 2, -.5F, .5F};
  static constexpr auto fields() {
    return std::tuple{
        numberField("right", &MoveOperation::right, kWidths, "Right",
                    "How far the lamp moves to the right, in per cent of the picture's width; below 0: to "
                    "the left."),
        numberField("up", &MoveOperation::up, kWidths, "Up",
                    "How far the lamp moves up, in per cent of the picture's width; below 0: down."),
        numberField("distance", &MoveOperation::distance, {Scale::Unit::Factor, .25, 4, .5F, 2}, "Distance",
                    "Times the lamp's distance from what it lights: below 1 it comes nearer, and its light "
                    "gets brighter and falls off faster.")};
  }
  [[nodiscard]] std::string summary() const {
    return fmt::format("{:+.0f} %, {:+.0f} %, x {:.2f}", 100 * right, 100 * up, distance);
  }
  [[nodiscard]] LampChange lampChange() const {
    LampChange change;
    change.right = right;
    change.up = up;
    change.distance = distance;
    return change;
  }
  [[nodiscard]] PlanePoint handle(const LampInHand& held) const { return middleOf(held.lamp, lampChange()); }
  /// Moves the lamp so that the middle of its light comes to a place.
  void dragTo(const LampInHand& held, const PlanePoint& place) {
    const LampChange change = movedTo(held.lamp, place);
    right = kWidths.within(change.right);
    up = kWidths.within(change.up);
  }
};

}  // namespace swaplight
