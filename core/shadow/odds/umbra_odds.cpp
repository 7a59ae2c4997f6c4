#include "core/shadow/odds/umbra_odds.h"

#include <algorithm>
#include <cmath>

#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {
namespace {

constexpr int kSmallest = 8;        // pixels: pictures less wide or high tell nothing of shadows
constexpr float kLeastRange = .3f;  // log: a light whose levels differ by less is even, and has no shadow
constexpr double kFew = .005;       // share of the pixels beyond the ends of its range

bool isEven(const cv::Mat& grey) {
  const float most = percentile(grey, 1 - kFew);
  return most <= 0 || percentile(grey, kFew) > std::exp(-kLeastRange) * most;
}

}  // namespace

LightOdds umbraOdds(const SmallSet& set, size_t light) {
  if (std::min(set.total.rows, set.total.cols) < kSmallest || isEven(set.grey[light])) return {};
  return weighUmbra(umbraEvidence(set, light));
}

}  // namespace swaplight
