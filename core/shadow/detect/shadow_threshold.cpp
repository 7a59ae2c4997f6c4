#include "core/shadow/detect/shadow_threshold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {
namespace {

constexpr int kLevels = 128;

size_t binOf(float level, float low, float scale) {
  return static_cast<size_t>(std::clamp(static_cast<int>((level - low) * scale), 0, kLevels - 1));
}

// What is summed along the contour of each level.
struct Contours {
  std::array<double, kLevels + 1> edge{}, slope{}, length{}, pixels{}, ratio{};

  // The contours between two neighbours' levels pass through here.
  void add(size_t a, size_t b, float edgeHere, float slopeHere) {
    const size_t low = std::min(a, b), high = std::max(a, b);
    edge[low] += edgeHere, edge[high] -= edgeHere;
    slope[low] += slopeHere, slope[high] -= slopeHere;
    length[low] += 1, length[high] -= 1;
  }
  void accumulate() {
    for (auto* sum : {&edge, &slope, &length, &pixels, &ratio})
      for (size_t i = 1; i < sum->size(); ++i) (*sum)[i] += (*sum)[i - 1];
  }
};

/// The mean log-odds of light that each level leaves below it: all of the picture counts.
std::array<double, kLevels> oddsBelow(const cv::Mat& level, const cv::Mat& oddsOfLight, float low,
                                      float scale, const ShadowThresholdTuning& tuning) {
  std::array<double, kLevels> below{};
  const cv::Mat small = shrunk(level, oddsOfLight.size());
  for (int y = 0; y < small.rows; ++y)
    for (int x = 0; x < small.cols; ++x) {
      const double odds = oddsOfLight.at<float>(y, x);
      below[binOf(small.at<float>(y, x), low, scale)] += std::clamp(odds, -tuning.mostUmbra, tuning.mostLit);
    }
  std::partial_sum(below.begin(), below.end(), below.begin());
  for (double& sum : below) sum /= static_cast<double>(small.total());
  return below;
}

}  // namespace

float litLevel(const ShadowEvidence& light, const cv::Mat& known) {
  return percentile(light.level, .95, known);
}

float shadowThreshold(const ShadowEvidence& light, const cv::Mat& known, const cv::Mat& oddsOfLight,
                      const ShadowThresholdTuning& tuning) {
  const float low = percentile(light.level, .005, known);
  const float high = percentile(light.level, .995, known);
  const float lit = percentile(light.level, .99, known);
  if (!light.shines) return high + tuning.outside;
  if (!(high > low)) return low - tuning.outside;
  const float scale = kLevels / (high - low);
  const auto binAt = [&](int y, int x) { return binOf(light.level.at<float>(y, x), low, scale); };

  // Let every pair of neighbours vote for the levels between them.
  Contours contours;
  const auto vote = [&](int y, int x, int y2, int x2) {
    if (!known.at<uchar>(y2, x2)) return;
    const float edge = .5f * (light.edge.at<float>(y, x) + light.edge.at<float>(y2, x2));
    const float slope = .5f * (light.slope.at<float>(y, x) + light.slope.at<float>(y2, x2));
    contours.add(binAt(y, x), binAt(y2, x2), edge, slope);
  };
  for (int y = 0; y < known.rows; ++y)
    for (int x = 0; x < known.cols; ++x) {
      if (!known.at<uchar>(y, x)) continue;
      contours.pixels[binAt(y, x)] += 1;
      contours.ratio[binAt(y, x)] += light.ratio.at<float>(y, x);
      if (x + 1 < known.cols) vote(y, x, y, x + 1);
      if (y + 1 < known.rows) vote(y, x, y + 1, x);
    }
  contours.accumulate();

  // The best of the levels that divide better than their neighbours.
  const double leastEdge = tuning.leastEdge / std::max(referenceUnit(known), tuning.smallestUnit);
  std::array<double, kLevels> score{};
  for (size_t i = 0; i < kLevels; ++i) {
    const double above = 1 - contours.pixels[i] / contours.pixels[kLevels];
    if (contours.length[i] < 1 || above < tuning.leastLit || above > 1 - .005) continue;
    const double mean = contours.edge[i] / contours.length[i];
    const double unshared = contours.edge[i] / std::max(contours.slope[i], 1e-9);
    if (mean * unshared < leastEdge) continue;
    // What is dark under every light alike is a dark surface, not this light's shadow.
    const double below = contours.pixels[i];
    const double all = contours.pixels[kLevels];
    const double step = (contours.ratio[kLevels] - contours.ratio[i]) / (all - below) -
                        contours.ratio[i] / std::max(below, 1.);
    const double trust = std::clamp(step / tuning.fullRatio, tuning.leastTrust, 1.);
    const double level = low + (static_cast<double>(i) + 1) / scale - lit;
    const double apart = level - std::log(tuning.usualLevel);
    const double unusual = apart / (apart < 0 ? tuning.spreadBelow : tuning.spreadAbove);
    score[i] = mean * unshared * trust * std::exp(-unusual * unusual / 2) *
               std::pow(contours.length[i], tuning.lengthBonus);
  }
  const auto smoothed = [&](size_t i) { return score[i - 1] + 2 * score[i] + score[i + 1]; };
  const auto isPeak = [&, reach = static_cast<size_t>(tuning.peakReach)](size_t i) {
    const size_t end = std::min<size_t>(i + reach, kLevels - 2);
    for (size_t j = std::max<size_t>(i, reach + 1) - reach; j <= end; ++j)
      if (smoothed(j) > smoothed(i)) return false;
    return true;
  };
  std::array<double, kLevels> litInShadow{}, value{};
  if (!oddsOfLight.empty()) litInShadow = oddsBelow(light.level, oddsOfLight, low, scale, tuning);
  for (size_t i = 1; i + 1 < kLevels; ++i)
    if (isPeak(i))
      value[i] = smoothed(i) * std::pow(1 - contours.pixels[i] / contours.pixels[kLevels], tuning.areaBonus) *
                 std::exp(-tuning.oddsWeight * litInShadow[i]);
  // Of levels that divide alike the darkest: the lighter ones run through what is lit.
  const double enough = tuning.alike * *std::max_element(value.begin(), value.end());
  const auto best = std::find_if(value.begin(), value.end(), [&](double v) { return v >= enough; });
  return enough > 0 ? low + (static_cast<float>(best - value.begin()) + 1) / scale : low - tuning.outside;
}

}  // namespace swaplight
