#include "core/shadow/detect/shadow_preview.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>

#include "core/set/shrunk_set.h"
#include "core/shadow/detect/shadow_cut.h"
#include "core/shadow/detect/shadow_regions.h"
#include "core/shadow/detect/shadow_threshold.h"
#include "core/shadow/evidence/shadow_evidence.h"
#include "core/shadow/marks/settled_pixels.h"
#include "core/shadow/numeric/shadow_pictures.h"
#include "core/shadow/odds/umbra_odds.h"

namespace swaplight {

/// What each light's marks said last: they stay as they are while a hand drags the threshold.
struct LastWords {
  struct Word {
    ShadowMarks marks;
    cv::Mat word;
  };
  std::mutex mutex;
  std::vector<Word> words;

  template <typename Make>
  cv::Mat of(size_t light, const ShadowMarks& marks, const Make& make) {
    {
      const std::lock_guard lock(mutex);
      if (words[light].marks == marks) return words[light].word;
    }
    const cv::Mat word = make();
    const std::lock_guard lock(mutex);
    words[light] = {marks, word};
    return word;
  }
};

namespace {

constexpr double kPixels = 1.2e6;

// What the search for shadows looks at, smaller by a whole factor.
SolvedSet smallerSet(const SolvedSet& set, int factor, const Progress& progress) {
  return shrunkSet(set, std::max(1, set.width() / factor), std::max(1, set.height() / factor), progress);
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

ShadowPreview::ShadowPreview(const SolvedSet& set, const Progress& progress)
    : m_width(set.width()), m_height(set.height()) {
  const auto pixels = static_cast<double>(set.contributions.front().pixelCount());
  const int factor = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kPixels))));
  const Progress gathering = progress.part(.1f, 1);
  auto evidence = std::make_shared<SetEvidence>(
      factor > 1 ? gatherShadowEvidence(smallerSet(set, factor, progress), gathering)
                 : gatherShadowEvidence(set, gathering));
  m_scale = static_cast<float>(set.width()) / static_cast<float>(evidence->known.cols);
  std::vector<float> thresholds;
  const UmbraOdds umbraOdds(smallSetOf(set.contributions, sizeWithin(evidence->known.size(), kUmbraLongest)));
  for (size_t i = 0; i < evidence->lights.size(); ++i) {
    const ShadowEvidence& light = evidence->lights[i];
    const float lit = litLevel(light, evidence->known);
    PreviewedLight& previewed = m_lights.emplace_back();
    previewed.odds = std::make_shared<const LightOdds>(light.shines ? umbraOdds.of(i) : LightOdds{});
    thresholds.push_back(shadowThreshold(light, evidence->known, evidenceOfLight(*previewed.odds)));
    previewed.histogram = histogramOf(light.level, evidence->known, lit);
    previewed.lit = lit;
    previewed.threshold = std::exp(thresholds.back() - lit);
  }
  const std::vector<cv::Mat> bright = brightParts(*evidence, thresholds);
  for (size_t i = 0; i < m_lights.size(); ++i)
    m_lights[i].sides = std::make_shared<const ShadowSides>(shadowSides(*evidence, bright, i));
  m_words = std::make_shared<LastWords>();
  m_words->words.resize(m_lights.size());
  evidence->contributions.clear();
  for (ShadowEvidence& light : evidence->lights)
    for (cv::Mat* used : {&light.slope, &light.edge, &light.ratio}) used->release();
  m_evidence = std::move(evidence);
}

PreviewedShadows ShadowPreview::shadows(size_t light, const std::optional<float>& threshold,
                                        const ShadowMarks& marks) const {
  const float given = std::max(threshold.value_or(m_lights[light].threshold), 1e-6f);
  const cv::Mat& known = m_evidence->known;
  const int smallest = smallestShadow({}, known);
  const float level = m_lights[light].lit + std::log(given);
  const PreviewedLight& previewed = m_lights[light];
  const ShadowEvidence& evidence = m_evidence->lights[light];
  const cv::Size size = previewed.sides->apart.size();
  const cv::Size picture(m_width, m_height);
  const cv::Mat word = m_words->of(light, marks, [&] {
    return wordOfMarks(
        marks, {shrunk(evidence.shading, size), previewed.sides->own, evidenceOfLight(*previewed.odds)},
        picture);
  });
  const ShadowDivision division = divideShadow(shrunk(evidence.level, size), level, *previewed.sides,
                                               threshold ? LightOdds{} : *previewed.odds, word);
  const SettledPixels settled(marks, picture, word, division.shadow, known.size());
  cv::Mat visibility = visibilityOf(evidence, division.shadow, known, smallest, {}, settled.pixels());
  settled.pinIn(visibility);
  cv::Mat told = toldPixels(division, known);
  settled.tellIn(told);
  return {labelShadows(visibility, told), known.cols, m_scale};
}

float stopsFromThreshold(float threshold) {
  return std::log2(threshold);
}

float thresholdFromStops(float stops) {
  return std::exp2(stops);
}

float surelyShadowStops() {
  return ShadowCutTuning{}.surelyShadow / std::numbers::ln2_v<float>;
}

float surelyLitStops() {
  return ShadowCutTuning{}.surelyLit / std::numbers::ln2_v<float>;
}

}  // namespace swaplight
