#pragma once

#include <string>

#include "ui/studio_context.h"

namespace swaplight {

/// Shows a light changed while a gesture goes on; `what` names the step, as "stops".
void previewLight(StudioContext& studio, size_t light, const std::string& what, const LightSetting& setting);
/// Changes a light as one step.
void editLight(StudioContext& studio, size_t light, const std::string& what, const LightSetting& setting);

/// The display codes of a light's hue at full brightness, for chips.
[[nodiscard]] Rgb chipColor(const LightColor& color);

/// A light's colour in a few words, as a person gave it: "3200 K", "#ff8040", "white, L201".
[[nodiscard]] std::string colorWords(const LightColor& color);
/// sRGB codes 0..1 as "#rrggbb".
[[nodiscard]] std::string hexText(const Rgb& codes);

}  // namespace swaplight
