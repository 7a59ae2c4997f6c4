#include "core/shadow/odds/umbra_odds.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc/edge_filter.hpp>

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

LightOdds umbraOdds(const SmallSet& set, size_t light, const UmbraOddsTuning& tuning) {
  if (std::min(set.total.rows, set.total.cols) < kSmallest || isEven(set.grey[light])) return {};
  const LightOdds odds = weighUmbra(umbraEvidence(set, light));
  if (tuning.pooling <= 0) return odds;
  const float unit = referenceUnit(set.total);
  cv::Mat guide[3] = {set.grey[light].clone(), set.total - set.grey[light], set.total.clone()};
  for (cv::Mat& g : guide) {
    cv::GaussianBlur(g, g, {}, 1.2 * unit, 0, cv::BORDER_REPLICATE);
    g = cv::max(g, 0) + 1e-3;
    cv::log(g, g);
  }
  cv::Mat edges;
  cv::merge(guide, 3, edges);
  const cv::Mat plain[2] = {odds.umbra, odds.lit};
  cv::Mat both, pooled[2];
  cv::merge(plain, 2, both);
  cv::ximgproc::dtFilter(edges, both, both, tuning.pooling * unit, tuning.edge);
  cv::split(both, pooled);
  return {pooled[0], pooled[1], odds.visible};
}

}  // namespace swaplight
