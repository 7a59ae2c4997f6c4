#pragma once

#include <string>
#include <vector>

#include "core/relight/rig.h"

namespace swaplight {

/// The display codes of a light's hue at full brightness, for chips.
[[nodiscard]] Rgb chipColor(const LightColor& color);
/// A light's colour in a few words, as a person gave it: "3200 K", "#ff8040", "white, L201".
[[nodiscard]] std::string colorWords(const LightColor& color);
/// What to say of `what` ("strokes") on lights of which none gives light now, as "key gives no light now
/// (off): strokes on it show once it does."; empty where one of them does.
[[nodiscard]] std::string unseenEditWords(const Rig& rig, const std::vector<std::string>& lights,
                                          const std::string& what);
/// sRGB codes 0..1 as "#rrggbb".
[[nodiscard]] std::string hexText(const Rgb& codes);
/// A colour given by its sRGB codes.
[[nodiscard]] LightColor hexColor(const Rgb& codes);

}  // namespace swaplight
