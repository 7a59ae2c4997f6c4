#pragma once

#include <imgui.h>

#include "core/shadow/result/shadow_mark.h"

namespace swaplight {

/// What the legend explains: what is drawn.
struct ShadowLegend {
  bool outlines = false, untold = false, chosen = false, marks = false;
};

/// What the lines over the picture mean, in the viewer's corner. `origin` and `size` are the viewer's.
void drawShadowLegend(const ShadowLegend& legend, ImVec2 origin, ImVec2 size);

/// A person's mark, with its middle at a place of the screen.
void drawShadowMark(ShadowMark::Kind kind, ImVec2 at);

}  // namespace swaplight
