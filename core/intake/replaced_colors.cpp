#include "core/intake/replaced_colors.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "core/base/error.h"

namespace swaplight {
namespace {

constexpr float kSameGel = 0.2F;  // relative

/// Which of the first shot's colours a light has in a shot; -1: none.
int gelOf(const Shot& first, const Shot& shot, size_t light) {
  const std::string name = shot.colorName(light);
  const auto& color = shot.lightColors[light];
  int nearest = -1;
  float least = kSameGel;
  for (size_t i = 0; i < first.lightColors.size(); ++i) {
    if (!name.empty() && first.colorName(i) == name) return static_cast<int>(i);
    if (!color || !first.lightColors[i]) continue;
    const float length = glm::length(*first.lightColors[i]);
    const float apart = length > 0 ? glm::distance(*color, *first.lightColors[i]) / length : INFINITY;
    if (*color == *first.lightColors[i] || apart < least) {
      least = *color == *first.lightColors[i] ? 0 : apart;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

}  // namespace

Capture withReplacedColors(Capture capture, const std::vector<ShotColor>& colors) {
  if (colors.size() != capture.lights.size())
    throw InputError("{} colours for {} lights: give one a light, as in the first photograph", colors.size(),
                     capture.lights.size());
  const Shot first = capture.shots.front();
  for (size_t i = 0; i < colors.size(); ++i)
    if (!first.lightColors[i] && first.colorName(i).empty())
      throw InputError(
          "the capture does not say what {} had in the first photograph, so its gel cannot be followed; give "
          "it a name there, such as \"?a\"",
          capture.lights[i].name);
  for (Shot& shot : capture.shots) {
    std::vector<int> gels;
    for (size_t i = 0; i < colors.size(); ++i) gels.push_back(gelOf(first, shot, i));
    shot.colorNames.resize(colors.size());
    for (size_t i = 0; i < colors.size(); ++i) {
      if (gels[i] < 0) continue;
      shot.lightColors[i] = colors[static_cast<size_t>(gels[i])].color;
      shot.colorNames[i] = colors[static_cast<size_t>(gels[i])].name();
    }
  }
  return capture;
}

}  // namespace swaplight
