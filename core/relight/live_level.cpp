#include "core/relight/live_level.h"

#include <algorithm>
#include <cmath>

#include "core/relight/level.h"

namespace swaplight {
namespace {

const LightGroup* groupOf(const Rig& rig, const LightSetting& light) {
  if (light.group.empty()) return nullptr;
  const auto group = std::find_if(rig.groups.begin(), rig.groups.end(),
                                  [&](const LightGroup& other) { return other.name == light.group; });
  return group == rig.groups.end() ? nullptr : &*group;
}

HeldBack heldBack(const Rig& rig, const LightSetting& light) {
  const LightGroup* group = groupOf(rig, light);
  const auto isSolo = [](const LightSetting& other) { return other.solo; };
  if (light.mute) return HeldBack::Muted;
  if (!light.on) return HeldBack::Off;
  if (group && !group->on) return HeldBack::GroupOff;
  if (!light.solo && std::any_of(rig.lights.begin(), rig.lights.end(), isSolo)) return HeldBack::NotInSolo;
  return levelOf(light) > 0 ? HeldBack::Nothing : HeldBack::LevelZero;
}

}  // namespace

float groupStops(const Rig& rig, const LightSetting& light) {
  const LightGroup* group = groupOf(rig, light);
  return group ? group->stops : 0;
}

LiveLevel liveLevel(const Rig& rig, size_t index) {
  const LightSetting& light = rig.lights.at(index);
  const HeldBack by = heldBack(rig, light);
  if (by != HeldBack::Nothing) return {0, by};
  return {levelOf(light) * std::exp2(static_cast<double>(groupStops(rig, light))), by};
}

const char* heldBackWords(HeldBack by) {
  switch (by) {
    case HeldBack::Nothing:
      break;
    case HeldBack::Muted:
      return "muted";
    case HeldBack::Off:
      return "off";
    case HeldBack::GroupOff:
      return "group off";
    case HeldBack::NotInSolo:
      return "not in solo";
    case HeldBack::LevelZero:
      return "level 0";
  }
  return "";
}

}  // namespace swaplight
