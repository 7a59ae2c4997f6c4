#include "core/solve/highlights/highlight_holes.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace swaplight {
namespace {

constexpr int kMostNeighbours = 8;
constexpr int kSurrounded = 5;  // of them have highlights
constexpr int kRowsAtOnce = 32;
constexpr int kRounds = 4;  // holes are single pixels, and now and then a few

struct Neighbours {
  size_t at[kMostNeighbours];
  int count = 0;
};

Neighbours keptAround(const std::vector<bool>& kept, int width, int height, size_t p) {
  const int x = int(p % size_t(width)), y = int(p / size_t(width));
  Neighbours found;
  for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
    for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u)
      if (const size_t q = size_t(v) * size_t(width) + size_t(u); q != p && kept[q])
        found.at[found.count++] = q;
  return found;
}

/// What a light has at a pixel beyond the mean of its neighbours' matte rest, in all channels alike; no more
/// than its darkest channel, and no more than they have.
float heightBeside(const Image& light, const Image& highlight, size_t p, const Neighbours& around) {
  float beyond = 0, darkest = INFINITY, most = 0;
  for (int c = 0; c < 3; ++c) {
    float rest = 0;
    for (int j = 0; j < around.count; ++j)
      rest += light.plane(c)[around.at[j]] - highlight.plane(c)[around.at[j]];
    beyond += (light.plane(c)[p] - rest / float(around.count)) / 3;
    darkest = std::min(darkest, light.plane(c)[p]);
  }
  for (int j = 0; j < around.count; ++j) most = std::max(most, highlight.plane(0)[around.at[j]]);
  return std::clamp(beyond, 0.0F, std::max(std::min(darkest, most), 0.0F));
}

/// Gives a pixel its highlights; whether it has any.
bool fill(SolvedSet& set, size_t p, const Neighbours& around) {
  bool any = false;
  for (size_t i = 0; i < set.highlights.size(); ++i) {
    const float height = heightBeside(set.contributions[i], set.highlights[i], p, around);
    for (int c = 0; c < 3; ++c) set.highlights[i].plane(c)[p] = height;
    any |= height > 0;
  }
  return any;
}

}  // namespace

size_t fillHighlightHoles(SolvedSet& set, std::vector<bool>& kept, const Progress& progress) {
  const int width = set.width();
  size_t filled = 0;
  for (int round = 0; round < kRounds; ++round) {
    progress.stopIfAsked();
    std::vector<std::vector<size_t>> holes(size_t(set.height()));
    parallelRows(set.height(), kRowsAtOnce, [&](int begin, int end) {
      for (int y = begin; y < end; ++y)
        for (size_t p = size_t(y) * size_t(width); p < size_t(y + 1) * size_t(width); ++p)
          if (!kept[p] && keptAround(kept, width, set.height(), p).count >= kSurrounded)
            holes[size_t(y)].push_back(p);
    });
    std::vector<size_t> found;
    for (const auto& row : holes)
      for (const size_t p : row)
        if (fill(set, p, keptAround(kept, width, set.height(), p))) found.push_back(p);
    if (found.empty()) break;
    for (const size_t p : found) kept[p] = true;
    filled += found.size();
  }
  return filled;
}

}  // namespace swaplight
