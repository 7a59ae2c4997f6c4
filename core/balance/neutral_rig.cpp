#include "core/balance/neutral_rig.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "core/base/error.h"
#include "core/color/chromaticity.h"

namespace swaplight {
Rig neutralized(Rig rig, std::span<const size_t> lights, const WhitePoint& white) {
  for (const size_t i : lights) {
    LightSetting& light = rig.lights.at(i);
    const float level = luminance(colorFactor(light.color));
    if (!(level > 0)) continue;
    light.color = lightColorOfWhite(white);
    const float ofWhite = luminance(colorFactor(light.color));  // 1, but for rounding
    light.stops = std::clamp(light.stops + std::log2(level / ofWhite), -kMostStops, kMostStops);
  }
  return rig;
}

std::vector<size_t> lightsFromText(const Rig& rig, const std::string& text) {
  constexpr std::string_view kAllBut = "all-but:";
  const bool allBut = text.starts_with(kAllBut);
  std::vector<bool> named(rig.lights.size(), text == "all");
  std::istringstream names(allBut ? text.substr(kAllBut.size()) : text == "all" ? "" : text);
  Rig known = rig;  // findLight lists the names
  for (std::string name; std::getline(names, name, ',');)
    named[size_t(&findLight(known, name) - known.lights.data())] = true;
  if (names.str().empty() && text != "all")
    throw InputError("--lights \"{}\": names no light: give all, names as in key,fill, or all-but:key", text);
  std::vector<size_t> chosen;
  for (size_t i = 0; i < named.size(); ++i)
    if (named[i] != allBut) chosen.push_back(i);
  return chosen;
}

}  // namespace swaplight
