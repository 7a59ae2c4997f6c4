#include "core/cue/stage.h"

#include <algorithm>

#include "core/look/rig_blend.h"
#include "core/relight/live_level.h"

namespace swaplight {
namespace {

const LightSetting* lightNamed(const Rig& rig, const std::string& name) {
  const auto found = std::find_if(rig.lights.begin(), rig.lights.end(),
                                  [&](const LightSetting& light) { return light.light == name; });
  return found == rig.lights.end() ? nullptr : &*found;
}

bool isAdded(const EditStack& edits, const std::string& light) {
  return std::find(edits.newLights.begin(), edits.newLights.end(), light) != edits.newLights.end();
}

/// The lights of the set, then those that the edits add: of `rig`, else as in a new light.
Rig rigForEdits(const Rig& rig, const EditStack& before, const EditStack& edits) {
  Rig fitted = rig;
  std::erase_if(fitted.lights, [&](const LightSetting& light) {
    return isAdded(before, light.light) || isAdded(edits, light.light);
  });
  for (const std::string& name : edits.newLights) {
    const LightSetting* known = lightNamed(rig, name);
    LightSetting added;
    added.light = name;
    fitted.lights.push_back(known ? *known : added);
  }
  return fitted;
}

/// With the lights of the other, dark where this one does not have them.
Rig withLightsOf(Rig rig, const Rig& other) {
  for (const LightSetting& light : other.lights) {
    if (lightNamed(rig, light.light)) continue;
    rig.lights.push_back(light);
    rig.lights.back().on = false;
    rig.lights.back().solo = false;
  }
  return rig;
}

}  // namespace

Stage stageOf(const SavedLook& look, const Stage& now) {
  if (!look.scene) return {blendRigs(now.rig, look.rig, 1), now.edits};
  Rig rig = rigForEdits(now.rig, now.edits, look.scene->edits);
  return {blendRigs(rig, look.rig, 1), look.scene->edits};
}

StageFade::StageFade(Stage from, Stage to)
    : m_from(std::move(from)),
      m_to(std::move(to)),
      m_fromAll(withLightsOf(m_from.rig, m_to.rig)),
      m_toAll(withLightsOf(m_to.rig, m_from.rig)),
      m_edits(m_from.edits, m_to.edits) {}

Stage StageFade::at(float amount) const {
  if (amount <= 0) return m_from;
  if (amount >= 1) return m_to;
  return {blendRigs(m_fromAll, m_toAll, amount), m_edits.at(amount)};
}

bool StageFade::movesBeside(const std::set<std::string>& lights) const {
  if (m_from.edits != m_to.edits || m_from.rig.ambient != m_to.rig.ambient) return true;
  return std::any_of(m_fromAll.lights.begin(), m_fromAll.lights.end(), [&](const LightSetting& light) {
    return !lights.contains(light.light) && light != *lightNamed(m_toAll, light.light);
  });
}

std::optional<std::set<std::string>> changedLights(const Rig& before, const Rig& now) {
  Rig same = now;
  if (before.lights.size() != now.lights.size()) return std::nullopt;
  std::set<std::string> changed;
  for (size_t i = 0; i < now.lights.size(); ++i) {
    if (before.lights[i].light != now.lights[i].light) return std::nullopt;
    if (before.lights[i] != now.lights[i]) changed.insert(now.lights[i].light);
  }
  same.lights = before.lights;
  return same == before ? std::optional(changed) : std::nullopt;
}

Rig withLightsAsIn(const Rig& other, const std::set<std::string>& lights, Rig rig) {
  for (LightSetting& light : rig.lights)
    if (const LightSetting* set = lightNamed(other, light.light); set && lights.contains(light.light))
      light = *set;
  return rig;
}

Rig withoutGroups(Rig rig) {
  const Rig before = rig;
  for (size_t i = 0; i < rig.lights.size(); ++i) {
    LightSetting& light = rig.lights[i];
    light.on = liveLevel(before, i).by == HeldBack::Nothing;
    light.stops = std::clamp(light.stops + groupStops(before, light), -kMostStops, kMostStops);
    light.solo = light.mute = false;
    light.group.clear();
  }
  rig.groups.clear();
  return rig;
}

}  // namespace swaplight
