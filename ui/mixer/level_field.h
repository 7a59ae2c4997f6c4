#pragma once

#include <optional>
#include <string>

#include "ui/control/lights_context.h"

namespace swaplight {

/// What was done to a level in its field.
struct LevelChange {
  double level;  ///< as a factor of the captured one
  bool typed;    ///< else dragged: the gesture goes on
};

/// The level of a light or a group, as a number in the mixer's unit. Dragging changes it, ten times finer
/// with Shift; a double-click or Ctrl-click types it, in all the words of core/relight/level.h; Tab goes on
/// to the next one. What lies beyond the sliders' range cannot be dragged, and is typed by a second Enter
/// only. `mark` names the field and its row.
std::optional<LevelChange> levelField(LightsContext& studio, const std::string& mark, double level);

/// From the next frame on the level of this row is typed.
void typeLevel(MixerState& mixer, const std::string& mark, double level);

}  // namespace swaplight
