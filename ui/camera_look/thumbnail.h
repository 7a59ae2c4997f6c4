#pragma once

#include <imgui.h>

#include <string>

#include "ui/control/viewer_context.h"

namespace swaplight {

/// The frame through these filters, as large as it fits between two corners, in their middle; a dark place as
/// long as it is not drawn yet. `key` tells apart what is shown at the same time.
void drawThumbnail(ViewerContext& studio, const std::string& key, const FilterPipeline& look, ImVec2 low,
                   ImVec2 high);

}  // namespace swaplight
