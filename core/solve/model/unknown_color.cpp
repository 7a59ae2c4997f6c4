#include "core/solve/model/unknown_color.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/capture/lightings.h"

namespace swaplight {
namespace {

bool hasLight(const std::optional<Rgb>& color) {
  return color && std::min({color->r, color->g, color->b}) > 0;
}

/// Whether `first` has the known gel in shot a, and the other light in shot b; the unknown one elsewhere.
bool areSwapped(const Shot& a, const Shot& b, size_t first) {
  const size_t second = 1 - first;
  return hasLight(a.lightColors[first]) && hasLight(b.lightColors[second]) && !a.lightColors[second] &&
         !b.lightColors[first];
}

}  // namespace

std::vector<UnknownColor> unknownColorsOf(const Capture& capture) {
  std::vector<UnknownColor> all;
  for (int k = 0; k < capture.shotCount(); ++k)
    for (int i = 0; i < capture.lightCount(); ++i) {
      const Shot& shot = capture.shots[size_t(k)];
      if (shot.lightColors[size_t(i)]) continue;
      const std::string name = shot.colorName(size_t(i));
      const auto known = std::find_if(all.begin(), all.end(), [&](const UnknownColor& other) {
        return !name.empty() && other.name == name;
      });
      UnknownColor& unknown = known != all.end() ? *known : all.emplace_back(UnknownColor{name, {}});
      unknown.entries.push_back(k * capture.lightCount() + i);
    }
  return all;
}

std::string wordsFor(const UnknownColor& unknown, const LightingMatrix& lighting) {
  std::vector<std::string> places;
  for (const int entry : unknown.entries)
    places.push_back(fmt::format("{} in shot {}", lighting.names[size_t(entry % lighting.lights)],
                                 entry / lighting.lights + 1));
  return unknown.name.empty() ? fmt::format("the colour of {}", places.front())
                              : fmt::format("{} ({})", unknown.name, fmt::join(places, ", "));
}

std::optional<SwappedColor> swappedColorOf(const Capture& capture) {
  if (capture.lightCount() != 2) return std::nullopt;
  for (int a = 0; a < capture.shotCount(); ++a)
    for (int b = a + 1; b < capture.shotCount(); ++b)
      for (int first = 0; first < 2; ++first) {
        const Shot &one = capture.shots[size_t(a)], &other = capture.shots[size_t(b)];
        if (!areSwapped(one, other, size_t(first))) continue;
        const bool open = std::all_of(capture.shots.begin(), capture.shots.end(), [&](const Shot& shot) {
          return &shot == &one || &shot == &other || litAlike(shot, one) || litAlike(shot, other);
        });
        return SwappedColor{{a, b}, {first, 1 - first}, open};
      }
  return std::nullopt;
}

}  // namespace swaplight
