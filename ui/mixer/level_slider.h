#pragma once

#include <string>

#include "ui/state/mixer_state.h"

namespace swaplight {

/// What the mouse and the keys did to a level slider in one frame.
struct LevelSliding {
  bool changed = false;
  bool nudged = false;  ///< by the wheel or an arrow key, with nothing held
  bool hovered = false;
  bool toType = false;  ///< Ctrl-click: the level is to be typed
};

/// A slider of stops from -range to +range: the middle is 0, where it is finest, its bar runs from there;
/// marks at 1, 2, 3 and 6 stops. It takes the handle to the mouse and drags it, ten times finer with Shift;
/// the wheel and the arrow keys over it step by a tenth of a stop, with Shift by a hundredth; a double-click
/// puts it back to 0.
LevelSliding levelSlider(const char* id, float* stops, float range, float width);

/// Steps by the wheel or the keys are one gesture until the mouse leaves the slider of this row.
void keepNudges(MixerState& mixer, const std::string& row, const LevelSliding& sliding);

}  // namespace swaplight
