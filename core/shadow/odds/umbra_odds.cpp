#include "core/shadow/odds/umbra_odds.h"

#include <algorithm>
#include <cmath>

#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {
namespace {

constexpr int kSmallest = 8;        // pixels: pictures less wide or high tell nothing of shadows
constexpr float kLeastRange = .3f;  // log: a light whose levels differ by less is even, and has no shadow
constexpr int kMostTaught = 400;    // pixels of the longer side that the network knows: a larger picture ...
constexpr double kTaught = 320;     // ... is brought to the size that most of its lessons had
constexpr double kCoarse = .4;      // weight of what half as large pictures say
constexpr double kFew = .005;       // share of the pixels beyond the ends of its range

SmallSet resized(const SmallSet& set, cv::Size size) {
  SmallSet small;
  for (const cv::Mat& rgb : set.rgb) {
    small.rgb.push_back(shrunk(rgb, size));
    small.grey.push_back(greyOf(small.rgb.back()));
  }
  small.totalRgb = shrunk(set.totalRgb, size);
  small.total = greyOf(small.totalRgb);
  return small;
}

bool isEven(const cv::Mat& grey) {
  const float most = percentile(grey, 1 - kFew);
  return most <= 0 || percentile(grey, kFew) > std::exp(-kLeastRange) * most;
}

}  // namespace

LightOdds umbraOdds(const SmallSet& set, size_t light) {
  const cv::Size full = set.total.size();
  if (std::min(full.height, full.width) < kSmallest || isEven(set.grey[light])) return {};
  const int longest = std::max(full.width, full.height);
  const cv::Size size = longest <= kMostTaught ? full : sizeDivided(full, longest / kTaught);
  const LightOdds fine = weighUmbra(umbraEvidence(size == full ? set : resized(set, size), light));
  const cv::Size half = sizeDivided(size, 2);
  const bool asked = std::min(half.height, half.width) >= kSmallest;
  const LightOdds coarse = asked ? weighUmbra(umbraEvidence(resized(set, half), light)) : fine;
  const auto both = [&](const cv::Mat& one, const cv::Mat& other) {
    return cv::Mat((1 - kCoarse) * grown(one, full) + kCoarse * grown(other, full));
  };
  return {both(fine.umbra, coarse.umbra), both(fine.lit, coarse.lit), both(fine.visible, coarse.visible)};
}

}  // namespace swaplight
