#include "core/edit/mask/surface_color.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace swaplight {

Rgb surfaceColor(const SolvedSet& set, const PreparedMask& mask) {
  constexpr int kRows = 256;  // at most so many are looked at
  const PixelRect& area = mask.bounds();
  std::vector<float> part(static_cast<size_t>(std::max(area.width, 0)));
  double sum[3] = {}, weight = 0;
  const int step = 1 + area.height / kRows;
  for (int y = area.y; y < area.bottom(); y += step) {
    if (!mask.row(area.x, y, area.width, part.data())) continue;
    for (int x = 0; x < area.width; ++x) {
      const double m = part[static_cast<size_t>(x)];
      if (m <= 0) continue;
      weight += m;
      for (const Image& light : set.contributions)
        for (int c = 0; c < 3; ++c) sum[c] += m * std::max(light.view().at(c, area.x + x, y), 0.0F);
    }
  }
  Rgb mean(1);
  for (int c = 0; c < 3; ++c)
    if (weight > 0) mean[c] = static_cast<float>(sum[c] / weight);
  return std::max({mean.r, mean.g, mean.b}) > 0 ? mean : Rgb(1);
}

}  // namespace swaplight
