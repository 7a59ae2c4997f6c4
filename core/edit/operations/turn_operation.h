#pragma once

#include <fmt/core.h>

#include <string>

#include "core/edit/fields/field.h"
#include "core/edit/operations/operation_info.h"
#include "core/edit/pool/lamp_handle.h"

namespace swaplight {

/// The light's lamp turned in its place. Acts on the light's contribution and always adds: see
/// edit/pool/lamp_gain.h.
struct TurnOperation {
  float pan = 0;   ///< degrees to the right
  float tilt = 0;  ///< degrees up
  bool operator==(const TurnOperation&) const = default;

  static constexpr OperationInfo info{"turn", "Turn the lamp",
                                      "Points the light elsewhere; its lamp stays in its place. Where a "
                                      "spot's cone comes to surfaces that it never lit, "
                                      "the light is a guess, continued by what the other lights show."};
  static constexpr Scale kDegrees{Scale::Unit::Degrees, -90, 90, -45, 45};
  static constexpr auto fields() {
    return std::tuple{numberField("pan", &TurnOperation::pan, kDegrees, "Pan",
                                  "Degrees that the light's beam swings to the right; below 0: to the left."),
                      numberField("tilt", &TurnOperation::tilt, kDegrees, "Tilt",
                                  "Degrees that the light's beam swings up; below 0: down.")};
  }
  [[nodiscard]] std::string summary() const { return fmt::format("{:+.0f}\u00b0, {:+.0f}\u00b0", pan, tilt); }
  [[nodiscard]] LampChange lampChange() const {
    LampChange change;
    change.pan = pan;
    change.tilt = tilt;
    return change;
  }
  [[nodiscard]] PlanePoint handle(const LampInHand& held) const { return middleOf(held.lamp, lampChange()); }
  /// Turns the lamp so that the middle of its light comes to a place.
  void dragTo(const LampInHand& held, const PlanePoint& place) {
    const LampChange change = turnedTo(held.lamp, place);
    pan = kDegrees.within(change.pan);
    tilt = kDegrees.within(change.tilt);
  }
};

}  // namespace swaplight
