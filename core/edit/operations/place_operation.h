#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/edit/fields/field.h"
#include "core/edit/operations/operation_info.h"
#include "core/edit/pool/lamp_handle.h"
#include "core/normals/lamp_place.h"

namespace swaplight {

/// The light of a lamp that stands elsewhere, or of one that the set never had, by how the surfaces are
/// turned: see edit/placing/placed_change.h. Acts on the light's contribution and always adds.
struct PlaceOperation {
  float azimuth = 0;    ///< degrees to the right of the camera, as LampPlace has it
  float elevation = 0;  ///< degrees above the line from the set to the camera
  float distance = 0;   ///< widths of the picture; 0: far, its light is parallel
  float diameter = 0;   ///< of the lamp, over its distance
  bool operator==(const PlaceOperation&) const = default;

  static constexpr OperationInfo info{
      "place", "Place the lamp",
      "Lights the set from another side, by how its surfaces are turned. Say first where the lamps of three "
      "lights stood. Shadows that things throw on others keep their shape, and a new light throws none."};
  static constexpr bool kUsesShadows = true;
  static constexpr auto fields() {
    return std::tuple{
        numberField(
            "azimuth", &PlaceOperation::azimuth, {Scale::Unit::Degrees, -180, 180, -180, 180}, "Side",
            "Degrees to the right of the camera, seen from the set: -90 is left, 180 behind the set."),
        numberField("elevation", &PlaceOperation::elevation, {Scale::Unit::Degrees, -90, 90, -90, 90},
                    "Height", "Degrees above the line from the set to the camera."),
        numberField(
            "distance", &PlaceOperation::distance, {Scale::Unit::Widths, 0, 1000, 0, 10, "far"}, "Distance",
            "From the middle of the set, in widths of what the picture shows there: a set that is 3 m "
            "wide, a lamp 6 m away: 2. 0: far away, as the sun."),
        numberField("diameter", &PlaceOperation::diameter, {Scale::Unit::Percent, 0, 4, 0, 2}, "Diameter",
                    "The lamp's diameter, in per cent of its distance: a large one lights around corners.")};
  }
  /// A new lamp: from the left, above.
  static PlaceOperation initial() { return {-45, 30, 0, .3F}; }
  [[nodiscard]] std::string summary() const {
    return fmt::format("{:+.0f}\u00b0, {:+.0f}\u00b0", azimuth, elevation);
  }
  [[nodiscard]] LampPlace place() const {
    LampPlace place{azimuth, elevation, {}, {}};
    if (distance > 0) place.distance = distance;
    return place;
  }
  /// The direction to the lamp as a place on a ball of kBall before the middle of the set; where it is behind
  /// the set, on the ball's far side.
  [[nodiscard]] PlanePoint handle(const LampInHand& /*held*/) const {
    const cv::Vec3d to = LampRays(place()).at(0, 0).direction;
    return {kBall * to[0], kBall * to[1]};
  }
  void dragTo(const LampInHand& /*held*/, const PlanePoint& to) {
    const bool behind = std::abs(azimuth) > 90;
    const double reach = std::max(std::hypot(to.x, to.y) / kBall, 1.);
    const double x = to.x / kBall / reach;
    const double y = to.y / kBall / reach;
    const double z = std::sqrt(std::max(1 - x * x - y * y, 0.)) * (behind ? -1 : 1);
    const double degrees = 180 / std::numbers::pi;
    azimuth = static_cast<float>(std::round(degrees * std::atan2(x, z)));
    elevation = static_cast<float>(std::round(degrees * std::asin(std::clamp(y, -1., 1.))));
  }
  static constexpr double kBall = 0.22;  ///< widths of the picture
  /// Of a lamp that stood there.
  [[nodiscard]] static PlaceOperation at(const LampPlace& place) {
    return {static_cast<float>(place.azimuth), static_cast<float>(place.elevation),
            static_cast<float>(place.distance.value_or(0)), 0};
  }
};

}  // namespace swaplight
