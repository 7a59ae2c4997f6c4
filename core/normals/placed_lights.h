#pragma once

#include <string>
#include <vector>

#include "core/capture/capture.h"
#include "core/normals/surface_normals.h"

namespace swaplight {

/// Those of a set's lights whose lamps' places were told.
struct PlacedLights {
  std::vector<PlacedLight> lamps;    ///< that normals can be told by
  std::vector<std::string> tooNear;  ///< LampPlace::isTooNear: not used
};

/// Throws InputError: a light that the set lacks, stops of some lamps but not of all, fewer than three lamps
/// that can be used. `where` begins its words.
[[nodiscard]] PlacedLights placedLights(const LampPlaces& places, const Capture& capture,
                                        const std::string& where);

}  // namespace swaplight
