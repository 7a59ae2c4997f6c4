#pragma once

#include <imgui.h>

#include <string>

#include "core/color/rgb.h"

namespace swaplight {

// A card over the picture with the lights' shares of a pixel.
inline constexpr float kSharesWidth = 250;  ///< at scale 1
inline constexpr ImGuiWindowFlags kCardFlags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize;

/// One light's share of a pixel in a line of its own: name, bar, per cent. `lit` sets it off from the others.
void drawShareBar(const std::string& name, float share, const Rgb& color, bool lit = false);

}  // namespace swaplight
