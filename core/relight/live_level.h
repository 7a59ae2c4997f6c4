#pragma once

#include "core/relight/rig.h"

namespace swaplight {

/// What keeps a light from giving anything, the nearest to the light first.
enum class HeldBack { Nothing, Muted, Off, GroupOff, NotInSolo, LevelZero };

/// What comes out of a light once its switches, its group and the solos of others have had their say.
struct LiveLevel {
  double level = 0;  ///< a factor of the captured level: the light's own times its group's; 0 where held back
  HeldBack by = HeldBack::Nothing;
};
[[nodiscard]] LiveLevel liveLevel(const Rig& rig, size_t light);

/// The stops of the light's group; 0 without one, and where the group is not there.
[[nodiscard]] float groupStops(const Rig& rig, const LightSetting& light);

/// "muted", "off", "group off", "not in solo", "level 0"; empty for nothing.
[[nodiscard]] const char* heldBackWords(HeldBack by);

}  // namespace swaplight
