#include "core/shadow/odds/umbra_odds.h"

#include <algorithm>
#include <cmath>

#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {
namespace {

constexpr int kSmallest = 8;        // pixels: pictures less wide or high tell nothing of shadows
constexpr float kLeastRange = .3f;  // log: a light whose levels differ by less is even, and has no shadow
constexpr double kCoarse = .4;      // weight of what half as large pictures say
constexpr double kFew = .005;       // share of the pixels beyond the ends of its range

SmallSet halved(const SmallSet& set) {
  SmallSet half;
  const cv::Size size = sizeDivided(set.total.size(), 2);
  for (const cv::Mat& rgb : set.rgb) {
    half.rgb.push_back(shrunk(rgb, size));
    half.grey.push_back(greyOf(half.rgb.back()));
  }
  half.totalRgb = shrunk(set.totalRgb, size);
  half.total = greyOf(half.totalRgb);
  return half;
}

bool isEven(const cv::Mat& grey) {
  const float most = percentile(grey, 1 - kFew);
  return most <= 0 || percentile(grey, kFew) > std::exp(-kLeastRange) * most;
}

}  // namespace

LightOdds umbraOdds(const SmallSet& set, size_t light) {
  if (std::min(set.total.rows, set.total.cols) < kSmallest || isEven(set.grey[light])) return {};
  LightOdds odds = weighUmbra(umbraEvidence(set, light));
  if (std::min(set.total.rows, set.total.cols) < 2 * kSmallest) return odds;
  const LightOdds coarse = weighUmbra(umbraEvidence(halved(set), light));
  const auto heed = [](cv::Mat& fine, const cv::Mat& word) {
    fine = (1 - kCoarse) * fine + kCoarse * grown(word, fine.size());
  };
  heed(odds.umbra, coarse.umbra);
  heed(odds.lit, coarse.lit);
  heed(odds.visible, coarse.visible);
  return odds;
}

}  // namespace swaplight
