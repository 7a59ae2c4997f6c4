#pragma once

#include <imgui.h>

#include <array>
#include <optional>

#include "ui/control/editing_context.h"

namespace swaplight {

/// A pixel of the picture.
struct PicturePixel {
  int x = 0, y = 0;
};

/// Where the mouse is in the picture; `origin` is the corner of the pane under it.
[[nodiscard]] std::array<float, 2> pointAtMouse(const ViewWindow& window, ImVec2 origin);

/// The pixel of the open set under the mouse; nothing beside the picture.
[[nodiscard]] std::optional<PicturePixel> pixelUnder(const EditingContext& studio, const ViewWindow& window,
                                                     ImVec2 origin);
/// The pixel under the mouse, where that is over the picture that was drawn last.
[[nodiscard]] std::optional<PicturePixel> pixelAtMouse(const EditingContext& studio);

}  // namespace swaplight
