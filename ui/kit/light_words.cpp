#include "ui/kit/light_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "core/color/srgb.h"
#include "core/relight/live_level.h"

namespace swaplight {

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

std::string unseenEditWords(const Rig& rig, const std::vector<std::string>& lights, const std::string& what) {
  std::vector<std::string> titles;
  HeldBack by = HeldBack::Nothing;
  for (size_t i = 0; i < rig.lights.size(); ++i) {
    if (std::find(lights.begin(), lights.end(), rig.lights[i].light) == lights.end()) continue;
    const LiveLevel live = liveLevel(rig, i);
    if (live.level > 0) return {};
    titles.push_back(rig.lights[i].title());
    by = live.by;
  }
  if (titles.empty()) return {};
  if (titles.size() == 1)
    return fmt::format("{} gives no light now ({}): {} on it show once it does.", titles.front(),
                       heldBackWords(by), what);
  return fmt::format("{} give no light now: {} on them show once they do.", fmt::join(titles, ", "), what);
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
