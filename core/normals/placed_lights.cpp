#include "core/normals/placed_lights.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/capture/no_such_light.h"
#include "core/normals/normal_fit.h"

namespace swaplight {
namespace {

void checkMeter(const LampPlaces& places, const std::string& where) {
  for (const auto& [light, place] : places)
    if (place.stops.has_value() != places.begin()->second.stops.has_value())
      throw InputError("{}: \"{}\" {} and \"{}\" {}: say the stops of all lamps, or of none", where, light,
                       place.stops ? "has stops" : "has none", places.begin()->first,
                       place.stops ? "none" : "has them");
}

}  // namespace

PlacedLights placedLights(const LampPlaces& places, const Capture& capture, const std::string& where) {
  checkMeter(places, where);
  PlacedLights placed;
  for (const auto& [light, place] : places) {
    const size_t index = placeOfLight(capture, light, where);
    if (place.isTooNear())
      placed.tooNear.push_back(light);
    else
      placed.lamps.push_back({index, place});
  }
  if (placed.lamps.size() >= kFewestLamps) return placed;
  if (placed.tooNear.empty())
    throw InputError(
        "{}: {} of {} are known. Say where that many lamps stood: how surfaces are turned is told by them",
        where, places.size(), kFewestLamps);
  throw InputError(
      "{}: how surfaces are turned cannot be told: {} nearer than {} widths of the picture, where light "
      "comes "
      "from another direction in every place; {} lamps farther off are needed",
      where, fmt::join(placed.tooNear, ", "), LampPlace::kNearest, kFewestLamps);
}

}  // namespace swaplight
