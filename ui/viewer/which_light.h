#pragma once

#include <imgui.h>

#include <optional>

#include "ui/control/viewer_context.h"
#include "ui/tools/pointer.h"

namespace swaplight {

// "Which light is this?" While its key is held, a card at the mouse shows the lights' shares of the pixel,
// and a click selects the light that gives most; another click on the same pixel the next one.

/// The key is held, and is not being typed.
[[nodiscard]] bool asksWhichLight(const ViewerContext& studio);
void drawWhichLight(ViewerContext& studio, ImVec2 origin, ImVec2 size);
/// What a click on a pixel does; nothing beside the picture.
void selectLightOf(ViewerContext& studio, const std::optional<PicturePixel>& pixel);

}  // namespace swaplight
