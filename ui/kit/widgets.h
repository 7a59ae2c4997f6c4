#pragma once

#include <imgui.h>

#include <string>

#include "core/color/rgb.h"

namespace swaplight {

// Small parts that panels are made of. Those that take a value return true in the frames in which it changes.

/// A square button with a letter or icon, lit in a colour while on. True when clicked.
bool toggleButton(const char* label, bool on, ImU32 litColor, float side, const char* tooltip);

/// A filled, rounded swatch of display codes. True when clicked.
bool colorChip(const char* id, const Rgb& codes, ImVec2 size, const char* tooltip);

/// A slider of colour temperature in equal steps of reciprocal Kelvin, warm on the left.
bool kelvinSlider(const char* id, float* kelvin, float width);

/// Minus to plus green, -1..1; double-click on it resets.
bool greenSlider(const char* id, float* green, float width);

/// A dot that says that a value differs from the capture and resets it. True when clicked; leaves its room
/// empty where nothing differs.
bool changedDot(const char* id, bool changed, const char* tooltip);

/// Between them buttons look chosen, under the pointer too, where they are.
void pushChosen(bool chosen);
void popChosen();

/// Text in the faint colour and the small font.
void hint(const std::string& text);

/// Text in the present font, cut with dots where it is wider than there is room; nothing where the dots are.
[[nodiscard]] std::string cutToWidth(const std::string& text, float width);

/// A tooltip where the pointer is.
void tooltipAtOnce(const char* text);
/// One for the widget before, after the usual delay.
void tooltip(const char* text);

/// A thin bar between two panels. Moves `length` (at scale 1) by the mouse; `sign` is +1 where dragging right
/// or down makes it longer.
void splitter(const char* id, bool vertical, float thickness, float extent, float* length, float low,
              float high, float sign);

/// A texture of OpenGL from corner to corner, where the panel is drawn now.
void drawTexture(unsigned texture, ImVec2 low, ImVec2 high);

[[nodiscard]] ImU32 colorU32(const Rgb& codes, float alpha = 1);

}  // namespace swaplight
