#pragma once

#include <optional>

#include "core/edit/pool/light_cone.h"
#include "core/edit/pool/small_light.h"

namespace swaplight {

/// The light's cone, if it has one in the picture, with its edge where half of the light is, as soft as it
/// is. `small` is the light's; the edge is measured in larger pictures of it. `light` is an index of the
/// set's lights.
[[nodiscard]] std::optional<LightCone> coneOf(const SolvedSet& set, size_t light, const SmallLight& small);

}  // namespace swaplight
