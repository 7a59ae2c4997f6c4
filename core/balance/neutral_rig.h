#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/balance/white_point.h"
#include "core/relight/rig.h"

namespace swaplight {

/// The rig with these lights (indices) white, each as bright as it was: the colour is that of the white
/// point, the luminance that the colour took from it goes into the stops. A light whose colour is black
/// stays.
[[nodiscard]] Rig neutralized(Rig rig, std::span<const size_t> lights, const WhitePoint& white);

/// Lights by name: "all", "key,fill", or "all-but:key,fill". Indices into the rig. Throws InputError that
/// lists the known ones.
[[nodiscard]] std::vector<size_t> lightsFromText(const Rig& rig, const std::string& text);

}  // namespace swaplight
