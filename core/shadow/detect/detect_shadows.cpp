#include "core/shadow/detect/detect_shadows.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/shadow/detect/each_light.h"
#include "core/shadow/detect/penumbra.h"
#include "core/shadow/detect/shadow_cut.h"
#include "core/shadow/detect/shadow_evidence.h"
#include "core/shadow/detect/shadow_fill.h"
#include "core/shadow/detect/shadow_regions.h"
#include "core/shadow/detect/shadow_sides.h"
#include "core/shadow/detect/shadow_threshold.h"
#include "core/shadow/numeric/shadow_pictures.h"
#include "core/shadow/odds/umbra_odds.h"

namespace swaplight {
namespace {

Image imageOf(const cv::Mat& picture, std::vector<std::string> channels, float scale) {
  const int count = picture.channels();
  Image image(ImageSpec{picture.cols, picture.rows, std::move(channels), "lin_rec709"});
  for (int y = 0; y < picture.rows; ++y) {
    const auto* in = picture.ptr<float>(y);
    for (int x = 0; x < picture.cols; ++x)
      for (int c = 0; c < count; ++c) image.span().at(c, x, y) = in[x * count + c] * scale;
  }
  return image;
}

double shareOf(const LightShadows& shadows, ShadowLabel label) {
  const auto count = std::count(shadows.labels.begin(), shadows.labels.end(), label);
  return static_cast<double>(count) / static_cast<double>(std::max<size_t>(shadows.labels.size(), 1));
}

// The mean width of the penumbra: its area over half the length of its outline.
double penumbraPixels(const LightShadows& shadows) {
  const int width = shadows.visibility.width();
  const int height = shadows.visibility.height();
  double area = 0;
  double outline = 0;
  const auto isPenumbra = [&](int x, int y) {
    return shadows.labels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)] ==
           ShadowLabel::Penumbra;
  };
  for (int y = 0; y + 1 < height; ++y)
    for (int x = 0; x + 1 < width; ++x) {
      area += isPenumbra(x, y);
      outline += (isPenumbra(x, y) != isPenumbra(x + 1, y)) + (isPenumbra(x, y) != isPenumbra(x, y + 1));
    }
  // Steps along the pixel grid are longer than the line they follow, by 4 / pi on the mean of all directions.
  return outline > 0 ? 2 * area / (outline * .785) : 0;
}

void checkNames(const ShadowOptions& options, const Capture& capture) {
  for (const auto& [light, threshold] : options.thresholds)
    if (capture.lightIndex(light) < 0)
      throw InputError("a threshold of shadows is for the light \"{}\", which the set does not have.", light);
}

}  // namespace

std::vector<LightShadows> detectShadows(const SolvedSet& set, const ShadowOptions& options,
                                        const Progress& progress, const ShadowTuning& tuning) {
  checkNames(options, set.capture);
  const SetEvidence evidence = gatherShadowEvidence(set, progress.part(0, .3f), tuning.evidence);
  const int smallest = smallestShadow(options, evidence.known);
  const size_t count = evidence.lights.size();
  constexpr const char* kFinding = "finding shadows";

  std::vector<LightShadows> all(count);
  std::vector<float> thresholds(count);
  forEachLight(count, progress.part(.3f, .4f), kFinding, [&](size_t i) {
    const ShadowEvidence& light = evidence.lights[i];
    const float lit = litLevel(light, evidence.known);
    const std::optional<float> given = options.thresholdOf(set.capture.lights[i].name);
    thresholds[i] = given ? lit + std::log(std::max(*given, 1e-6f))
                          : shadowThreshold(light, evidence.known, tuning.threshold);
    all[i].threshold = std::exp(thresholds[i] - lit);
  });
  const std::vector<cv::Mat> bright = brightParts(evidence, thresholds);
  const SmallSet small =
      smallSetOf(evidence.contributions, sizeWithin(evidence.known.size(), tuning.odds.longest));
  std::vector<cv::Mat> divided(count);
  std::vector<cv::Mat> told(count);
  forEachLight(count, progress.part(.4f, .5f), kFinding, [&](size_t i) {
    const ShadowEvidence& light = evidence.lights[i];
    const ShadowSides sides = shadowSides(evidence, bright, i, tuning);
    // A threshold that is given is the user's word: nothing weighs against it.
    const bool weighed = light.shines && !options.thresholdOf(set.capture.lights[i].name);
    const ShadowDivision division =
        divideShadow(shrunk(light.level, sides.apart.size()), thresholds[i], sides,
                     weighed ? umbraOdds(small, i, tuning.odds) : LightOdds{}, tuning.cut);
    divided[i] = visibilityOf(light, division.shadow, evidence.known, smallest, tuning.regions);
    told[i] = toldPixels(division, evidence.known);
  });
  std::vector<RefinedVisibility> refined(count);
  std::vector<cv::Mat> visibilities(count);
  forEachLight(count, progress.part(.5f, .7f), kFinding, [&](size_t i) {
    refined[i] = refineVisibility(evidence, divided, i, tuning);
    visibilities[i] = refined[i].visibility;
  });
  forEachLight(count, progress.part(.7f, 1), "filling shadows", [&](size_t i) {
    FilledShadow filled = fillShadow(evidence, visibilities, refined[i].told, i, tuning);
    // After filling: what a surface that turns away still sees is dim of itself, and lacks nothing.
    cv::max(filled.visibility, refined[i].reached, filled.visibility);
    removeSmallShadows(filled.visibility, smallest, tuning.regions);
    all[i].labels = labelShadows(filled.visibility, told[i], tuning.regions);
    all[i].visibility = imageOf(filled.visibility, {"Y"}, 1);
    all[i].direct = imageOf(filled.direct, {"R", "G", "B"}, evidence.white);
    all[i].direct.setColorSpace(set.colorSpace());
  });
  return all;
}

Json jsonFromShadows(const LightShadows& shadows) {
  return {{"threshold", shadows.threshold},
          {"umbra", shareOf(shadows, ShadowLabel::Umbra)},
          {"penumbra", shareOf(shadows, ShadowLabel::Penumbra)},
          {"lit", shareOf(shadows, ShadowLabel::Lit)},
          {"unknown", shareOf(shadows, ShadowLabel::Unknown)},
          {"penumbra_pixels", penumbraPixels(shadows)}};
}

std::function<std::shared_ptr<const LightShadows>(const std::string& light)> shadowSource(
    std::shared_ptr<const SolvedSet> set, const ShadowOptions& options) {
  auto found = std::make_shared<std::vector<std::shared_ptr<const LightShadows>>>();
  return [set = std::move(set), options, found](const std::string& light) {
    const int index = set->capture.lightIndex(light);
    if (index < 0) throw InputError("\"{}\" is no light of the set: it has no shadows.", light);
    if (found->empty())
      for (LightShadows& shadows : detectShadows(*set, options))
        found->push_back(std::make_shared<const LightShadows>(std::move(shadows)));
    return (*found)[static_cast<size_t>(index)];
  };
}

}  // namespace swaplight
