#include "core/shadow/detect/detect_shadows.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/capture/no_such_light.h"
#include "core/set/shrunk_set.h"
#include "core/shadow/detect/enlarged_shadows.h"
#include "core/shadow/detect/penumbra.h"
#include "core/shadow/detect/shadow_cut.h"
#include "core/shadow/detect/shadow_fill.h"
#include "core/shadow/detect/shadow_regions.h"
#include "core/shadow/detect/shadow_sides.h"
#include "core/shadow/detect/shadow_threshold.h"
#include "core/shadow/detect/weighed_visibility.h"
#include "core/shadow/evidence/each_light.h"
#include "core/shadow/evidence/shadow_evidence.h"
#include "core/shadow/marks/mark_word.h"
#include "core/shadow/marks/settled_pixels.h"
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

void checkOptions(const ShadowOptions& options, const SolvedSet& set) {
  const auto check = [&](const char* what, const std::string& light) {
    static_cast<void>(placeOfLight(set.capture, light, what));
  };
  for (const auto& [light, threshold] : options.thresholds) check("a threshold of shadows", light);
  for (const auto& [light, marks] : options.marks) {
    check("a label of shadows", light);
    for (const ShadowMark& mark : marks)
      if (mark.x < 0 || mark.y < 0 || mark.x >= set.width() || mark.y >= set.height())
        throw InputError(
            "a label of the shadows of \"{}\" is at {}, {}, outside the picture of {} x {} pixels.", light,
            mark.x, mark.y, set.width(), set.height());
  }
}

// Pixels of the longer side: larger sets are searched at a fraction of their size, and what is found gets the
// set's own borders and grain. (The odds of umbra look at a smaller picture in any case.)
constexpr int kLongest = 1280;

/// The same of a smaller set: marks lie in its pixels.
ShadowOptions optionsFor(ShadowOptions options, cv::Size full, cv::Size small) {
  for (auto& [light, marks] : options.marks)
    for (ShadowMark& mark : marks) {
      const cv::Point at = markedPixel(mark, full, small);
      mark.x = at.x;
      mark.y = at.y;
    }
  return options;
}

/// What is said of a pixel holds for all those that the smaller set's pixel covers.
void obey(const ShadowMarks& marks, cv::Size full, cv::Size small, LightShadows& shadows) {
  for (const ShadowMark& mark : marks) {
    const cv::Point marked = markedPixel(mark, full, small);
    const int aroundX = full.width / small.width + 1, aroundY = full.height / small.height + 1;
    for (int y = std::max(mark.y - aroundY, 0); y <= std::min(mark.y + aroundY, full.height - 1); ++y)
      for (int x = std::max(mark.x - aroundX, 0); x <= std::min(mark.x + aroundX, full.width - 1); ++x) {
        if (markedPixel({mark.is, x, y}, full, small) != marked) continue;
        const bool lit = mark.is == ShadowMark::Kind::Lit;
        const size_t p = static_cast<size_t>(y) * static_cast<size_t>(full.width) + static_cast<size_t>(x);
        shadows.visibility.plane(0)[p] = lit ? 1 : 0;
        shadows.labels[p] = lit ? ShadowLabel::Lit : ShadowLabel::Umbra;
      }
  }
}

std::vector<LightShadows> ofLargeSet(const SolvedSet& set, int factor, const ShadowOptions& options,
                                     const Progress& progress, const ShadowTuning& tuning) {
  const cv::Size full(set.width(), set.height());
  const cv::Size size(std::max(1, full.width / factor), std::max(1, full.height / factor));
  const SolvedSet small = shrunkSet(set, size.width, size.height, progress.part(0, .1F));
  std::vector<LightShadows> found =
      detectShadows(small, optionsFor(options, full, size), progress.part(.1F, .8F), tuning);
  std::vector<LightShadows> all =
      enlargedShadows(set, small, std::move(found), progress.part(.8F, 1), tuning);
  for (size_t i = 0; i < all.size(); ++i)
    obey(options.marksOf(set.capture.lights[i].name), full, size, all[i]);
  return all;
}

}  // namespace

std::vector<LightShadows> detectShadows(const SolvedSet& set, const ShadowOptions& options,
                                        const Progress& progress, const ShadowTuning& tuning) {
  checkOptions(options, set);
  if (const int factor = (std::max(set.width(), set.height()) + kLongest - 1) / kLongest; factor > 1)
    return ofLargeSet(set, factor, options, progress, tuning);
  const SetEvidence evidence = gatherShadowEvidence(set, progress.part(0, .3f), tuning.evidence);
  const int smallest = smallestShadow(options, evidence.known);
  const size_t count = evidence.lights.size();
  constexpr const char* kFinding = "finding shadows";

  std::vector<LightShadows> all(count);
  std::vector<float> thresholds(count);
  std::vector<LightOdds> odds(count);
  const UmbraOdds umbraOdds(smallSetOf(set.contributions, sizeWithin(evidence.known.size(), kUmbraLongest)));
  forEachLight(count, progress.part(.3f, .4f), kFinding, [&](size_t i) {
    const ShadowEvidence& light = evidence.lights[i];
    const std::string& name = set.capture.lights[i].name;
    const std::optional<float> given = options.thresholdOf(name);
    // A threshold that is given is the user's word: nothing weighs against it.
    if (light.shines && (!given || !options.marksOf(name).empty())) odds[i] = umbraOdds.of(i);
    const float lit = litLevel(light, evidence.known);
    thresholds[i] = given
                        ? lit + std::log(std::max(*given, 1e-6f))
                        : shadowThreshold(light, evidence.known, evidenceOfLight(odds[i]), tuning.threshold);
    all[i].threshold = std::exp(thresholds[i] - lit);
  });
  const std::vector<cv::Mat> bright = brightParts(evidence, thresholds);
  std::vector<cv::Mat> divided(count);
  std::vector<cv::Mat> told(count);
  std::vector<std::optional<SettledPixels>> settled(count);
  forEachLight(count, progress.part(.4f, .5f), kFinding, [&](size_t i) {
    const ShadowEvidence& light = evidence.lights[i];
    const ShadowSides sides = shadowSides(evidence, bright, i, tuning);
    const std::string& name = set.capture.lights[i].name;
    const bool weighed = light.shines && !options.thresholdOf(name);
    const cv::Size size = sides.apart.size();
    const cv::Size full = light.level.size();
    const ShadowMarks& marks = options.marksOf(name);
    const cv::Mat word = wordOfMarks(
        marks, {shrunk(light.shading, size), sides.own, evidenceOfLight(odds[i])}, full, tuning.marks);
    ShadowDivision division = divideShadow(shrunk(light.level, size), thresholds[i], sides,
                                           weighed ? odds[i] : LightOdds{}, word, tuning);
    settled[i].emplace(marks, full, word, division.shadow, full, tuning.marks);
    divided[i] =
        visibilityOf(light, division.shadow, evidence.known, smallest, tuning.regions, settled[i]->pixels());
    settled[i]->pinIn(divided[i]);
    told[i] = toldPixels(division, evidence.known);
    settled[i]->tellIn(told[i]);
    odds[i] = std::move(division.odds);
  });
  std::vector<RefinedVisibility> refined(count);
  std::vector<cv::Mat> visibilities(count);
  forEachLight(count, progress.part(.5f, .7f), kFinding, [&](size_t i) {
    refined[i] = refineVisibility(evidence, divided, i, tuning);
    settled[i]->obeyIn(refined[i].visibility, divided[i]);
    settled[i]->denyIn(refined[i].reached);
    visibilities[i] = refined[i].visibility;
  });
  forEachLight(count, progress.part(.7f, 1), "filling shadows", [&](size_t i) {
    FilledShadow filled = fillShadow(evidence, visibilities, refined[i].told, i, tuning);
    // After filling: what a surface that turns away still sees is dim of itself, and lacks nothing.
    cv::max(filled.visibility, refined[i].reached, filled.visibility);
    filled.visibility = weighedVisibility(filled.visibility, refined[i].told, odds[i], tuning.regions);
    removeSmallShadows(filled.visibility, smallest, tuning.regions, settled[i]->pixels());
    settled[i]->obeyIn(filled.visibility, divided[i]);
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

ShadowSource shadowSource(std::shared_ptr<const SolvedSet> set, const ShadowOptions& options) {
  auto found = std::make_shared<std::vector<std::shared_ptr<const LightShadows>>>();
  return [set = std::move(set), options, found](const std::string& light) {
    const size_t place = placeOfLight(set->capture, light, "shadows");
    if (found->empty())
      for (LightShadows& shadows : detectShadows(*set, options))
        found->push_back(std::make_shared<const LightShadows>(std::move(shadows)));
    return (*found)[place];
  };
}

}  // namespace swaplight
