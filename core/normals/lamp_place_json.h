#pragma once

#include <string>

#include "core/base/json_fwd.h"
#include "core/normals/lamp_place.h"

namespace swaplight {

constexpr double kFarthestLamp = 1000;  ///< widths: farther is far
constexpr double kMostLampStops = 20;

/// {"key": {"azimuth": -40, "elevation": 30, "distance": 3, "stops": 1}, ...}; without a distance, or with 0,
/// the lamp is far, without stops nobody has metered it.
[[nodiscard]] Json jsonFromLampPlaces(const LampPlaces& places);
/// Throws InputError, which begins with `where`.
[[nodiscard]] LampPlaces lampPlacesFromJson(const Json& json, const std::string& where);

}  // namespace swaplight
