#include "core/shadow/shadow_preview.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/image/shrunk_image.h"
#include "core/shadow/penumbra.h"
#include "core/shadow/shadow_evidence.h"
#include "core/shadow/shadow_regions.h"
#include "core/shadow/shadow_threshold.h"

namespace swaplight {
namespace {

constexpr double kPixels = 1.2e6;

// What the search for shadows looks at, smaller by a whole factor.
SolvedSet shrunk(const SolvedSet& set, int factor, const Progress& progress) {
  SolvedSet small;
  small.capture = set.capture;
  const int width = std::max(1, set.width() / factor);
  const int height = std::max(1, set.height() / factor);
  for (const Image& contribution : set.contributions) {
    progress.update(0, "making a small picture");
    small.contributions.push_back(shrunkImage(contribution, width, height));
  }
  updateBeta(small);
  if (set.quality.empty()) return small;
  small.quality = shrunkImage(set.quality, width, height);
  // The mean of many pixels is surer than one of them.
  float* sigma = small.quality.plane(kSigma);
  for (size_t p = 0; p < small.quality.pixelCount(); ++p) sigma[p] /= static_cast<float>(factor);
  return small;
}

// Shadow and light, small parts left out.
cv::Mat divided(const ShadowEvidence& light, const cv::Mat& known, float threshold) {
  cv::Mat visibility = visibilityOf(light, known, threshold);
  static_cast<void>(labelShadows(visibility, known, smallestShadow({}, known)));
  return visibility;
}

ShadowHistogram histogramOf(const cv::Mat& level, const cv::Mat& known, float lit) {
  ShadowHistogram histogram;
  constexpr float kRange = ShadowHistogram::kHighestStops - ShadowHistogram::kLowestStops;
  double count = 0;
  for (int y = 0; y < level.rows; ++y)
    for (int x = 0; x < level.cols; ++x) {
      if (!known.at<uchar>(y, x)) continue;
      const float stops = (level.at<float>(y, x) - lit) / std::numbers::ln2_v<float>;
      const float bin =
          (stops - ShadowHistogram::kLowestStops) / kRange * static_cast<float>(ShadowHistogram::kBins);
      histogram
          .share[static_cast<size_t>(std::clamp(bin, 0.f, static_cast<float>(ShadowHistogram::kBins - 1)))] +=
          1;
      count += 1;
    }
  for (float& share : histogram.share) share /= static_cast<float>(std::max(count, 1.));
  return histogram;
}

}  // namespace

struct ShadowPreview::Found {
  SetEvidence evidence;
  std::vector<cv::Mat> visibilities;
};

ShadowPreview::ShadowPreview(const SolvedSet& set, const Progress& progress) {
  const auto pixels = static_cast<double>(set.contributions.front().pixelCount());
  const int factor = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kPixels))));
  const Progress gathering = progress.part(.1f, 1);
  auto found = std::make_shared<Found>();
  found->evidence = factor > 1 ? gatherShadowEvidence(shrunk(set, factor, progress), gathering)
                               : gatherShadowEvidence(set, gathering);
  const cv::Mat& known = found->evidence.known;
  m_scale = static_cast<float>(set.width()) / static_cast<float>(known.cols);
  for (ShadowEvidence& light : found->evidence.lights) {
    const float lit = litLevel(light, known);
    const float threshold = std::exp(shadowThreshold(light, known) - lit);
    m_lights.push_back({histogramOf(light.level, known, lit), lit, threshold});
    for (cv::Mat* used : {&light.slope, &light.edge, &light.ratio}) used->release();
    found->visibilities.push_back(divided(light, known, lit + std::log(threshold)));
  }
  m_found = std::move(found);
}

PreviewedShadows ShadowPreview::shadows(size_t light, const std::optional<float>& threshold) const {
  const SetEvidence& evidence = m_found->evidence;
  std::vector<cv::Mat> visibilities = m_found->visibilities;
  if (threshold)
    visibilities[light] = divided(evidence.lights[light], evidence.known,
                                  m_lights[light].lit + std::log(std::max(*threshold, 1e-6f)));
  cv::Mat refined = refineVisibility(evidence, visibilities, light).visibility;
  return {labelShadows(refined, evidence.known, smallestShadow({}, evidence.known)), evidence.known.cols,
          m_scale};
}

float stopsFromThreshold(float threshold) {
  return std::log2(threshold);
}

float thresholdFromStops(float stops) {
  return std::exp2(stops);
}

float shadowMarginStops() {
  return kShadowMargin / std::numbers::ln2_v<float>;
}

}  // namespace swaplight
