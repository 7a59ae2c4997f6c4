#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// What to do first: shown in the viewer's place while nothing is open.
void drawWelcomePanel(StudioContext& studio, const std::vector<std::filesystem::path>& samples);

}  // namespace swaplight
