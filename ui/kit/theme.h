#pragma once

#include <imgui.h>

#include "core/color/rgb.h"

namespace swaplight {

/// The fonts of the interface; made by applyTheme.
struct Fonts {
  ImFont* body = nullptr;
  ImFont* strong = nullptr;  ///< names, headings
  ImFont* small = nullptr;   ///< hints, axis labels
  ImFont* title = nullptr;   ///< the first screen
};
[[nodiscard]] const Fonts& fonts();

/// Loads the fonts and sets colours and sizes for a display scale (1 at 96 dots an inch). Between two frames.
void applyTheme(float scale);

/// A length of the design, given at scale 1, in pixels of this screen.
[[nodiscard]] float px(float length);
/// A length on this screen as it is at scale 1.
[[nodiscard]] float atScaleOne(float length);

/// Behind everything, as display codes.
[[nodiscard]] Rgb backgroundCode();

// The few colours with a meaning. Everything else is neutral grey, so that it does not tint the picture.
inline constexpr ImU32 kAccent = IM_COL32(96, 152, 224, 255);   ///< chosen, active
inline constexpr ImU32 kChanged = IM_COL32(240, 160, 64, 255);  ///< differs from the capture
inline constexpr ImU32 kSolo = IM_COL32(236, 196, 72, 255);
inline constexpr ImU32 kMute = IM_COL32(214, 92, 84, 255);
inline constexpr ImU32 kText = IM_COL32(226, 226, 226, 255);
inline constexpr ImU32 kFaint = IM_COL32(178, 178, 178, 255);
inline constexpr ImU32 kPanel = IM_COL32(38, 38, 38, 255);
inline constexpr ImU32 kCard = IM_COL32(50, 50, 50, 255);
inline constexpr ImU32 kCardChosen = IM_COL32(60, 66, 75, 255);
inline constexpr ImU32 kOutline = IM_COL32(74, 74, 74, 255);
inline constexpr ImU32 kViewerGround = IM_COL32(26, 26, 26, 255);

}  // namespace swaplight
