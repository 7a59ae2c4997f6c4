#pragma once

#include <string>

#include "core/relight/rig.h"

namespace swaplight {

/// The display codes of a light's hue at full brightness, for chips.
[[nodiscard]] Rgb chipColor(const LightColor& color);
/// A light's colour in a few words, as a person gave it: "3200 K", "#ff8040", "white, L201".
[[nodiscard]] std::string colorWords(const LightColor& color);
/// sRGB codes 0..1 as "#rrggbb".
[[nodiscard]] std::string hexText(const Rgb& codes);
/// A colour given by its sRGB codes.
[[nodiscard]] LightColor hexColor(const Rgb& codes);

}  // namespace swaplight
