#pragma once

#include <imgui.h>

#include "ui/control/viewer_context.h"

namespace swaplight {

/// Draws the rectangle that the scopes look at.
inline constexpr Tool kScopeRegion{
    "scopes.region", "Scope region", "Shift+S",
    "Draw a rectangle to limit the scopes to. Press again for the whole frame."};

/// Where the wipe's line and its handle for turning lie on the screen.
struct WipeHandles {
  ImVec2 center;
  ImVec2 along;  ///< unit vector
  ImVec2 turn;   ///< the handle
};
[[nodiscard]] WipeHandles wipeHandles(const Comparison& wipe, const ViewWindow& window, ImVec2 origin);

/// What the mouse does in the viewer, whose item was submitted last. `origin` is the corner of the pane under
/// the mouse.
void handleViewerMouse(ViewerContext& studio, const ViewWindow& window, ImVec2 origin);

}  // namespace swaplight
