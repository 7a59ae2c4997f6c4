#include "ui/control/light_edit.h"

#include <fmt/core.h>

#include <algorithm>

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

std::vector<size_t> lightsFor(const StudioContext& studio, size_t light) {
  const std::set<int>& chosen = studio.view.selectedLights;
  if (chosen.count(static_cast<int>(light)) == 0) return {light};
  std::vector<size_t> lights;
  for (const int i : chosen)
    if (i >= 0 && static_cast<size_t>(i) < studio.document().rig.lights.size())
      lights.push_back(static_cast<size_t>(i));
  return lights;
}

size_t shownLight(const StudioContext& studio) {
  const int last = static_cast<int>(studio.document().rig.lights.size()) - 1;
  return static_cast<size_t>(std::clamp(studio.view.selectedLight, 0, last));
}

void previewLights(StudioContext& studio, size_t light, const std::string& what, const LightChange& change) {
  const std::vector<size_t> lights = lightsFor(studio, light);
  studio.editor.preview(stepName(studio.document(), lights, what),
                        changed(studio.document(), lights, change));
}

void editLights(StudioContext& studio, size_t light, const std::string& what, const LightChange& change) {
  const std::vector<size_t> lights = lightsFor(studio, light);
  studio.editor.edit(stepName(studio.document(), lights, what), changed(studio.document(), lights, change));
}

void previewStops(StudioContext& studio, size_t light, float stops) {
  const std::vector<size_t> lights = lightsFor(studio, light);
  Document next = studio.document();
  next.rig = addStops(std::move(next.rig), lights, stops);
  studio.editor.preview(stepName(studio.document(), lights, "intensity"), std::move(next));
}

void editRig(StudioContext& studio, const std::string& step, const Rig& rig) {
  Document next = studio.document();
  next.rig = rig;
  studio.editor.edit(step, std::move(next));
}

void toggleSolo(StudioContext& studio, size_t light, bool alone) {
  const bool on = !studio.document().rig.lights[light].solo;
  if (!alone) {
    editLights(studio, light, on ? "solo" : "solo off", [&](LightSetting& setting) { setting.solo = on; });
    return;
  }
  Rig rig = studio.document().rig;
  for (LightSetting& other : rig.lights) other.solo = false;
  rig.lights[light].solo = true;
  editRig(studio, rig.lights[light].title() + ": solo alone", rig);
}

}  // namespace swaplight
