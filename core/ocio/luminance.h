#pragma once

#include <glm/mat3x3.hpp>
#include <optional>
#include <string>

#include "core/color/chromaticities.h"
#include "core/color/rgb.h"
#include "core/ocio/color_config.h"

namespace swaplight {

/// Relative luminance of linear Rec.709: Y of CIE XYZ.
inline constexpr Rgb kRec709Luminance{0.2126F, 0.7152F, 0.0722F};

/// CIE XYZ (white D65 at Y = 1) of a linear colour space's R, G, B; columns are its primaries. Throws
/// InputError on an unknown space.
[[nodiscard]] glm::mat3 xyzFromLinear(const ColorConfig& config, const std::string& colorSpace);

/// The primaries and the white of a linear colour space, as a file names them: of acescg and aces2065_1, and
/// of spaces that are the same under another name, those that are published, though their white is adapted
/// here; nothing where R, G, B are no colours. Throws InputError on an unknown space.
[[nodiscard]] std::optional<Chromaticities> chromaticitiesIn(const ColorConfig& config,
                                                             const std::string& colorSpace);

/// The weights with which R, G, B of a linear colour space add up to its luminance. Throws InputError on an
/// unknown space.
[[nodiscard]] Rgb luminanceWeights(const ColorConfig& config, const std::string& colorSpace);
/// The same of the spaces that the pictures of a set are kept in (lin_rec709, acescg, aces2065_1): their
/// primaries are published, whatever a configuration says. Throws InputError on another space.
[[nodiscard]] Rgb luminanceWeights(const std::string& colorSpace);

}  // namespace swaplight
