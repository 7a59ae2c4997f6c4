#pragma once

#include "ui/control/lights_context.h"

namespace swaplight {

/// The lines of a light's menu.
void drawLightMenu(LightsContext& studio, size_t light);
/// The lines of the mixer's menu: what is done to all lights.
void drawMixerMenu(LightsContext& studio);

/// The white points that lights are neutralized to, as a menu of its own.
void drawWhiteMenu(const ActionTable& actions);

/// From the next frame on the light's name is typed in its row.
void beginRename(LightsContext& studio, size_t light);
/// The rig without a group; its lights stand alone, as bright as they were.
[[nodiscard]] Rig withoutGroup(Rig rig, const std::string& name);

}  // namespace swaplight
