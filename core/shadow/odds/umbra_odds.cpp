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

bool isLargeEnough(cv::Size size) {
  return std::min(size.width, size.height) >= kSmallest;
}

bool isEven(const cv::Mat& grey) {
  const float most = percentile(grey, 1 - kFew);
  return most <= 0 || percentile(grey, kFew) > std::exp(-kLeastRange) * most;
}

}  // namespace

UmbraOdds::UmbraOdds(const SmallSet& set) : m_full(set.size()) {
  const int longest = std::max(m_full.width, m_full.height);
  m_fine = longest <= kMostTaught ? set : smallerSetOf(set, sizeDivided(m_full, longest / kTaught));
  m_coarse = smallerSetOf(m_fine, sizeDivided(m_fine.size(), 2));
}

LightOdds UmbraOdds::of(size_t light) const {
  if (!isLargeEnough(m_fine.size()) || isEven(m_fine.grey[light])) return {};
  const LightOdds fine = weighUmbra(umbraEvidence(m_fine, light));
  const LightOdds coarse = isLargeEnough(m_coarse.size()) ? weighUmbra(umbraEvidence(m_coarse, light)) : fine;
  const auto both = [&](const cv::Mat& one, const cv::Mat& other) {
    return cv::Mat((1 - kCoarse) * grown(one, m_full) + kCoarse * grown(other, m_full));
  };
  return {both(fine.umbra, coarse.umbra), both(fine.lit, coarse.lit), both(fine.visible, coarse.visible)};
}

}  // namespace swaplight
