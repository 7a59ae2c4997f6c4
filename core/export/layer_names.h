#pragma once

#include <span>
#include <string>
#include <vector>

namespace swaplight {

/// What Nuke makes of a layer's name: leading digits are dropped, every other character than a letter, a
/// digit or _ becomes _ (ExrChannelNameToNuke of its developer kit).
[[nodiscard]] std::string nukeName(const std::string& name);

/// A layer's name for each light, unchanged wherever compositors keep it: safe after Nuke's mangling, unique
/// without regard to case, and none of the layers that Nuke or this program keep for themselves (rgba, alpha,
/// depth, motion, mask, beta, quality, ambient ...): those are called light_<name>.
[[nodiscard]] std::vector<std::string> layerNames(std::span<const std::string> lights);

/// A layer's name for what of each of these layers is highlight: <layer>.spec, or another separator; with a
/// number (<layer>.spec_2) where Nuke would take it for one of the others.
[[nodiscard]] std::vector<std::string> highlightLayerNames(std::span<const std::string> layers,
                                                           char separator);

}  // namespace swaplight
