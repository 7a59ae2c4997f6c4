#pragma once

#include <optional>
#include <string>

#include "core/relight/rig.h"

namespace swaplight {

/// What the mixer remembers between frames and nobody saves.
struct MixerState {
  /// How the numbers beside the sliders are written.
  enum class Unit { Stops, Percent, Multiplier };
  Unit unit = Unit::Stops;
  std::optional<LightSetting> copied;
  int renaming = -1;  ///< the light whose name is being typed
  std::string name;   ///< what has been typed
  bool nameFocused = false;
  float hue = 0;          ///< of the last colour that had one: a grey has none
  std::string gelFilter;  ///< typed into the list of gels
  std::string groupName;  ///< typed into the menu
};

}  // namespace swaplight
