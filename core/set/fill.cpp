#include "core/set/fill.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace swaplight {
namespace {

struct Level {
  int width = 0;
  int height = 0;
  std::vector<float> value;
  std::vector<float> weight;  ///< 0 unknown .. 1 known
};

Level coarser(const Level& fine) {
  Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}, {}};
  coarse.value.resize(size_t(coarse.width) * size_t(coarse.height));
  coarse.weight.resize(coarse.value.size());
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x) {
      float sum = 0;
      float weight = 0;
      for (int dy = 0; dy < 2; ++dy)
        for (int dx = 0; dx < 2; ++dx) {
          const int fx = 2 * x + dx;
          const int fy = 2 * y + dy;
          if (fx >= fine.width || fy >= fine.height) continue;
          const size_t at = size_t(fy) * size_t(fine.width) + size_t(fx);
          sum += fine.weight[at] * fine.value[at];
          weight += fine.weight[at];
        }
      const size_t at = size_t(y) * size_t(coarse.width) + size_t(x);
      coarse.value[at] = weight > 0 ? sum / weight : 0;
      coarse.weight[at] = std::min(weight, 1.0F);
    }
  return coarse;
}

float bilinear(const Level& level, float x, float y) {
  const float cx = std::clamp(x, 0.0F, float(level.width - 1));
  const float cy = std::clamp(y, 0.0F, float(level.height - 1));
  const int x0 = int(cx);
  const int y0 = int(cy);
  const int x1 = std::min(x0 + 1, level.width - 1);
  const int y1 = std::min(y0 + 1, level.height - 1);
  const auto at = [&](int px, int py) { return level.value[size_t(py) * size_t(level.width) + size_t(px)]; };
  const float fx = cx - float(x0);
  const float fy = cy - float(y0);
  return (at(x0, y0) * (1 - fx) + at(x1, y0) * fx) * (1 - fy) +
         (at(x0, y1) * (1 - fx) + at(x1, y1) * fx) * fy;
}

void fillPlane(float* plane, int width, int height, const std::vector<uint8_t>& missing) {
  std::vector<Level> levels(1);
  levels[0] = {width, height, std::vector<float>(plane, plane + missing.size()),
               std::vector<float>(missing.size())};
  for (size_t p = 0; p < missing.size(); ++p) {
    levels[0].weight[p] = missing[p] ? 0.0F : 1.0F;
    if (missing[p]) levels[0].value[p] = 0;
  }
  while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(coarser(levels.back()));
  for (size_t l = levels.size() - 1; l-- > 0;) {
    Level& fine = levels[l];
    const Level& coarse = levels[l + 1];
    for (int y = 0; y < fine.height; ++y)
      for (int x = 0; x < fine.width; ++x) {
        const size_t at = size_t(y) * size_t(fine.width) + size_t(x);
        const float w = fine.weight[at];
        if (w < 1)
          fine.value[at] = w * fine.value[at] +
                           (1 - w) * bilinear(coarse, 0.5F * float(x) - 0.25F, 0.5F * float(y) - 0.25F);
      }
  }
  for (size_t p = 0; p < missing.size(); ++p)
    if (missing[p]) plane[p] = levels[0].value[p];
}

}  // namespace

void fillFromNeighbours(Image& image, const std::vector<uint8_t>& missing) {
  if (std::none_of(missing.begin(), missing.end(), [](uint8_t m) { return m != 0; })) return;
  parallelEach(image.channelCount(),
               [&](int c) { fillPlane(image.plane(c), image.width(), image.height(), missing); });
}

}  // namespace swaplight
