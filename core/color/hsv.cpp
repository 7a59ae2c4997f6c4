#include "core/color/hsv.h"

#include <algorithm>
#include <cmath>

namespace swaplight {

Rgb rgbFromHsv(const Rgb& hsv) {
  // Each channel is a trapezoid of the hue, a third of a turn apart.
  const auto channel = [&](float turn) {
    const float h = std::fabs(std::fmod(hsv.x + turn, 1.0f) * 6 - 3);
    return hsv.z * (1 - hsv.y * (1 - std::clamp(h - 1, 0.0f, 1.0f)));
  };
  return {channel(0), channel(2 / 3.0f), channel(1 / 3.0f)};
}

Rgb hsvFromRgb(const Rgb& rgb) {
  const float high = std::max({rgb.x, rgb.y, rgb.z});
  const float spread = high - std::min({rgb.x, rgb.y, rgb.z});
  if (!(spread > 0)) return {0, 0, high};
  float sixths = 0;
  if (high == rgb.x)
    sixths = (rgb.y - rgb.z) / spread + (rgb.y < rgb.z ? 6 : 0);
  else if (high == rgb.y)
    sixths = (rgb.z - rgb.x) / spread + 2;
  else
    sixths = (rgb.x - rgb.y) / spread + 4;
  return {sixths / 6, spread / high, high};
}

}  // namespace swaplight
