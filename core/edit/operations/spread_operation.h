#pragma once

#include <fmt/core.h>

#include <string>

#include "core/edit/fields/field.h"
#include "core/edit/operations/operation_info.h"
#include "core/edit/pool/lamp_handle.h"

namespace swaplight {

/// The light's beam wider or narrower: a spot's cone, or else the falloff over the set. Acts on the light's
/// contribution and always adds: see edit/pool/lamp_gain.h.
struct SpreadOperation {
  float width = 1;  ///< times the beam's width
  bool operator==(const SpreadOperation&) const = default;

  static constexpr OperationInfo info{
      "spread", "Spread of the beam",
      "Makes the light's beam wider or narrower, as an iris or a zoom would; the level in its middle stays."};
  static constexpr Scale kTimes{Scale::Unit::Factor, .25, 4, .25F, 4};
  static constexpr auto fields() {
    return std::tuple{
        numberField("width", &SpreadOperation::width, kTimes, "Width",
                    "Times the width of the beam: below 1 it narrows to a spot, above 1 the light gets "
                    "even over the set.")};
  }
  [[nodiscard]] std::string summary() const { return fmt::format("x {:.2f}", width); }
  [[nodiscard]] LampChange lampChange() const {
    LampChange change;
    change.spread = width;
    return change;
  }
  /// A ring is held, not the middle: it is drawn whole.
  static constexpr bool kHeldByRing = true;
  [[nodiscard]] PlanePoint handle(const LampInHand& held) const { return ringHandle(held, width); }
  /// Widens or narrows the beam so that the ring goes through a place.
  void dragTo(const LampInHand& held, const PlanePoint& place) {
    width = kTimes.within(static_cast<float>(spreadThrough(held, place)));
  }
};

}  // namespace swaplight
