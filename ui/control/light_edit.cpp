#include "ui/control/light_edit.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/relight/level.h"
#include "core/relight/rig_edit.h"

namespace swaplight {
namespace {

std::string stepName(const Document& document, const std::vector<size_t>& lights, const std::string& what) {
  if (lights.size() == 1) return document.rig.lights[lights.front()].title() + ": " + what;
  return fmt::format("{} lights: {}", lights.size(), what);
}

Document changed(Document document, const std::vector<size_t>& lights, const LightChange& change) {
  for (const size_t i : lights) change(document.rig.lights[i]);
  return document;
}

}  // namespace

std::vector<size_t> lightsFor(const ChosenLights& chosen, size_t light) {
  const std::set<int>& selected = chosen.view.selectedLights;
  if (selected.count(static_cast<int>(light)) == 0) return {light};
  std::vector<size_t> lights;
  for (const int i : selected)
    if (i >= 0 && static_cast<size_t>(i) < chosen.document().rig.lights.size())
      lights.push_back(static_cast<size_t>(i));
  return lights;
}

size_t shownLight(const ChosenLights& chosen) {
  const int last = static_cast<int>(chosen.document().rig.lights.size()) - 1;
  return static_cast<size_t>(std::clamp(chosen.view.selectedLight, 0, last));
}

void previewLights(const ChosenLights& chosen, size_t light, const std::string& what,
                   const LightChange& change) {
  const std::vector<size_t> lights = lightsFor(chosen, light);
  chosen.editor.preview(stepName(chosen.document(), lights, what),
                        changed(chosen.document(), lights, change));
}

void editLights(const ChosenLights& chosen, size_t light, const std::string& what,
                const LightChange& change) {
  const std::vector<size_t> lights = lightsFor(chosen, light);
  chosen.editor.edit(stepName(chosen.document(), lights, what), changed(chosen.document(), lights, change));
}

void previewStops(const ChosenLights& chosen, size_t light, float stops) {
  const std::vector<size_t> lights = lightsFor(chosen, light);
  Document next = chosen.document();
  next.rig = addStops(std::move(next.rig), lights, stops);
  chosen.editor.preview(stepName(chosen.document(), lights, "intensity"), std::move(next));
}

void previewLevel(const ChosenLights& chosen, size_t light, double level) {
  const double before = levelOf(chosen.document().rig.lights[light]);
  if (before > 0 && level > 0)
    previewStops(chosen, light, static_cast<float>(std::log2(level / before)));
  else
    previewLights(chosen, light, "intensity", [&](LightSetting& setting) { setLevel(setting, level); });
}

void editLevel(const ChosenLights& chosen, size_t light, double level) {
  const std::vector<size_t> lights = lightsFor(chosen, light);
  Document next = chosen.document();
  next.rig = withLevel(std::move(next.rig), lights, level);
  chosen.editor.edit(stepName(chosen.document(), lights, "intensity"), std::move(next));
}

void editRig(const ChosenLights& chosen, const std::string& step, const Rig& rig) {
  Document next = chosen.document();
  next.rig = rig;
  chosen.editor.edit(step, std::move(next));
}

void toggleSolo(const ChosenLights& chosen, size_t light, bool alone) {
  const bool on = !chosen.document().rig.lights[light].solo;
  if (!alone) {
    editLights(chosen, light, on ? "solo" : "solo off", [&](LightSetting& setting) { setting.solo = on; });
    return;
  }
  Rig rig = chosen.document().rig;
  for (LightSetting& other : rig.lights) other.solo = false;
  rig.lights[light].solo = true;
  editRig(chosen, rig.lights[light].title() + ": solo alone", rig);
}

}  // namespace swaplight
