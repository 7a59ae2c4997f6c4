#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/look/light_ratios.h"
#include "core/relight/rig.h"

namespace swaplight {

// Key, fill and back as roles of a rig's lights. What is said of a role is measured on its first light; what
// is done to it is done to all of its lights alike.

/// The lights that have a role, in the rig's order.
[[nodiscard]] std::vector<size_t> lightsOfRole(const Rig& rig, Role role);

/// log2 of the luminance that a light's dimmer, group and colour leave of its unit white; very negative for
/// black. Does not look at on, solo and mute.
[[nodiscard]] float settingStops(const Rig& rig, size_t light);

/// Stops of one role over another on the set: by the rig and by how bright the lights are (LightRatios). For
/// key over fill it is the lighting ratio: 2 stops are 4:1. Nothing where no light has one of the roles.
[[nodiscard]] std::optional<float> stopsOverRole(const Rig& rig, const LightRatios& ratios, Role role,
                                                 Role other);
/// The rig in which `role` is so many stops over `other`: the lights of `role` are dimmed and switched on,
/// all others stay.
[[nodiscard]] Rig withStopsOverRole(Rig rig, const LightRatios& ratios, Role role, Role other, float stops);

/// Stops as a ratio in words: "4:1", "1:1", "1:2", "2.8:1".
[[nodiscard]] std::string ratioWords(float stops);

/// How much warmer the key is than the fill, in mired (1e6 / Kelvin); negative: cooler. White is 6504 K.
/// Nothing where one of them is missing or has a colour that is not a white.
[[nodiscard]] std::optional<float> warmCoolSplit(const Rig& rig);
/// Key and fill as whites so far apart around 6504 K: the warm one takes two thirds of the way, because blue
/// ends sooner. mired in -kMostSplit .. kMostSplit.
[[nodiscard]] Rig withWarmCoolSplit(Rig rig, float mired);
inline constexpr float kMostSplit = 300;

}  // namespace swaplight
