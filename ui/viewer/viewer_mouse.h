#pragma once

#include <imgui.h>

#include <array>
#include <optional>

#include "ui/control/studio_context.h"

namespace swaplight {

/// A pixel of the picture.
struct PicturePixel {
  int x = 0, y = 0;
};

/// Where the wipe's line and its handle for turning lie on the screen.
struct WipeHandles {
  ImVec2 center;
  ImVec2 along;  ///< unit vector
  ImVec2 turn;   ///< the handle
};
[[nodiscard]] WipeHandles wipeHandles(const Comparison& wipe, const ViewWindow& window, ImVec2 origin);

/// Where the mouse is in the picture; `origin` is the corner of the pane under it.
[[nodiscard]] std::array<float, 2> pointAtMouse(const ViewWindow& window, ImVec2 origin);

/// What the mouse does in the viewer, whose item was submitted last. `origin` is the corner of the pane under
/// the mouse.
void handleViewerMouse(StudioContext& studio, const ViewWindow& window, ImVec2 origin);

/// The pixel under the mouse, where that is over the picture that was drawn last.
[[nodiscard]] std::optional<PicturePixel> pixelAtMouse(const StudioContext& studio);

}  // namespace swaplight
