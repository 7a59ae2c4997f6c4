#include "ui/control/light_edit.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/color/srgb.h"
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

Rgb chipColor(const LightColor& color) {
  const Rgb linear = glm::max(colorFactor(color), Rgb(0));
  const float brightest = std::max({linear.r, linear.g, linear.b});
  return brightest > 0 ? srgbFromLinear(linear / brightest) : Rgb(0);
}

std::string hexText(const Rgb& codes) {
  const auto byte = [](float code) { return std::lround(255 * std::clamp(code, 0.0F, 1.0F)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(codes.r), byte(codes.g), byte(codes.b));
}

LightColor hexColor(const Rgb& codes) {
  LightColor color;
  color.kind = LightColor::Kind::Hex;
  color.value = glm::clamp(codes, Rgb(0), Rgb(1));
  return color;
}

std::string colorWords(const LightColor& color) {
  std::string words;
  switch (color.kind) {
    case LightColor::Kind::White:
      words = "white";
      break;
    case LightColor::Kind::Kelvin:
      words = fmt::format("{:.0f} K", color.kelvin);
      break;
    case LightColor::Kind::Hex:
      words = hexText(color.value);
      break;
    case LightColor::Kind::LinearRgb:
    case LightColor::Kind::Hsv:
      words = hexText(chipColor(color));
      break;
  }
  if (color.green != 0) words += fmt::format(" {:+.2f} green", color.green);
  if (!color.gel.empty()) words += " + " + color.gel;
  return words;
}

}  // namespace swaplight
