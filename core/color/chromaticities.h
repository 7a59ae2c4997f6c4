#pragma once

#include <array>
#include <optional>
#include <string>

namespace swaplight {

/// CIE x, y of red, green, blue and white, as an EXR header holds them.
using Chromaticities = std::array<float, 8>;

/// Those of a scene-linear colour space by name (lin_rec709, acescg, aces2065_1); nothing for others.
[[nodiscard]] std::optional<Chromaticities> chromaticitiesOf(const std::string& colorSpace);

/// The scene-linear colour space that has these chromaticities, within 0.001: one of those, lin_rec2020 or
/// lin_p3d65; empty for others.
[[nodiscard]] std::string colorSpaceOf(const Chromaticities& chromaticities);

}  // namespace swaplight
