#pragma once

#include <imgui.h>

namespace swaplight {

// What the outlines, the legend and the histogram of shadows have in common: bright, and not a colour that
// lights usually have.
inline constexpr ImU32 kUmbraInk = IM_COL32(60, 214, 255, 255);
inline constexpr ImU32 kPenumbraInk = IM_COL32(255, 226, 64, 255);
inline constexpr ImU32 kUntoldInk = IM_COL32(240, 160, 64, 200);
inline constexpr ImU32 kChosenInk = IM_COL32(255, 255, 255, 255);

}  // namespace swaplight
