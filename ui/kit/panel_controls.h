#pragma once

#include <imgui.h>

namespace swaplight {

// What the panels at the left are made of.

/// Behind a label, where what it names begins. Pixels at scale 1.
inline constexpr float kLabelWidth = 77;
inline constexpr ImGuiSliderFlags kLogarithmic = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic;

/// One of several choices as a button. True when clicked.
bool choiceButton(const char* words, bool chosen, float width, const char* mark, const char* tip);
/// A slider behind its name.
bool labelledSlider(const char* label, const char* mark, float* value, float low, float high,
                    const char* format, const char* tip,
                    ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp);
/// The same for a part of 1, in percent up to `most`.
bool percentSlider(const char* label, const char* mark, float* part, float most, const char* tip);

}  // namespace swaplight
