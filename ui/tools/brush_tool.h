#pragma once

#include <imgui.h>

#include "ui/control/studio_context.h"

namespace swaplight {

/// What the mouse does in the viewer while the brush is in the hand; the viewer's item was submitted last.
/// `origin` is the corner of the pane under the mouse.
void handleBrush(StudioContext& studio, const ViewWindow& window, ImVec2 origin);

/// The brush's size, and within it where it is half as strong.
void drawBrushRing(StudioContext& studio, const ViewWindow& window, ImVec2 origin);

/// The brush's radius in pixels of the picture.
[[nodiscard]] float brushRadius(const StudioContext& studio);
void setBrushRadius(StudioContext& studio, float radius);

/// A light of its own without any light yet, for the brush to paint; takes the brush.
void addPaintedLight(StudioContext& studio);

/// What the brush does, as an edit without its mask.
[[nodiscard]] Edit brushEdit(const StudioContext& studio);

}  // namespace swaplight
