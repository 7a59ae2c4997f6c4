#pragma once

#include <optional>
#include <string>

#include "core/relight/level.h"
#include "core/relight/rig.h"

namespace swaplight {

/// A level that is being typed.
struct LevelTyping {
  std::string row;  ///< whose; empty: nobody's
  std::string text;
  std::string note;     ///< why it has not been taken
  std::string doubted;  ///< the text that the person was asked about
  bool focused = false;
};

/// What the mixer remembers between frames and nobody saves.
struct MixerState {
  LevelUnit unit = LevelUnit::Stops;  ///< of the numbers beside the sliders
  LevelTyping typing;
  bool typeNextLevel = false;  ///< Tab was pressed: the row after is typed
  std::string nudged;          ///< the row whose slider was stepped by the wheel or keys
  bool nudging = false;        ///< and the mouse is still over it: the gesture goes on
  std::optional<LightSetting> copied;
  int renaming = -1;  ///< the light whose name is being typed
  std::string name;   ///< what has been typed
  bool nameFocused = false;
  float hue = 0;          ///< of the last colour that had one: a grey has none
  std::string colorSeen;  ///< the light that was shown last, with its colour
  int scrolledTo = 0;     ///< the chosen light whose row was brought into view
  std::string gelFilter;  ///< typed into the list of gels
  std::string groupName;  ///< typed into the menu
};

}  // namespace swaplight
