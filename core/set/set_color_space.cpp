#include "core/set/set_color_space.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/color/chromaticities.h"

namespace swaplight {
namespace {

void convert(const ColorConfig& config, Image& picture, const std::string& colorSpace) {
  config.convert(picture.span(), picture.spec().colorSpace, colorSpace);
  picture.setColorSpace(colorSpace);
  for (int c = 0; c < 3; ++c)
    std::transform(picture.plane(c), picture.plane(c) + picture.pixelCount(), picture.plane(c),
                   [](float v) { return std::max(v, 0.0F); });
}

}  // namespace

std::string setColorSpaceWords(const std::string& colorSpace) {
  if (colorSpace == "lin_rec709") return "linear Rec.709";
  if (colorSpace == "acescg") return "ACEScg";
  if (colorSpace == "aces2065_1") return "ACES2065-1";
  return colorSpace;
}

void checkSetColorSpace(const std::string& colorSpace) {
  if (!colorSpace.empty() && !chromaticitiesOf(colorSpace))
    throw InputError(
        "the colour space {} is none that a set can be kept in: give lin_rec709, acescg or aces2065_1",
        colorSpace);
}

SolvedSet inColorSpace(const ColorConfig& config, SolvedSet set, const std::string& colorSpace,
                       const Progress& progress) {
  checkSetColorSpace(colorSpace);
  if (colorSpace.empty() || colorSpace == set.colorSpace()) return set;
  float done = 0;
  for (Image& contribution : set.contributions) {
    progress.update(done++ / static_cast<float>(set.lightCount()), "changing the working space");
    convert(config, contribution, colorSpace);
  }
  if (set.ambient) convert(config, *set.ambient, colorSpace);
  for (Image& highlight : set.highlights) convert(config, highlight, colorSpace);
  keepHighlightsInLights(set);
  return set;
}

SolvedSet copyInColorSpace(const ColorConfig& config, const SolvedSet& set, const std::string& colorSpace,
                           const Progress& progress) {
  SolvedSet copy{set.capture, {}, {}, set.beta.clone(), {}, set.quality.clone(), set.carried, set.report};
  copy.contributions.reserve(set.contributions.size());
  for (const Image& contribution : set.contributions) copy.contributions.push_back(contribution.clone());
  for (const Image& highlight : set.highlights) copy.highlights.push_back(highlight.clone());
  if (set.ambient) copy.ambient = set.ambient->clone();
  return inColorSpace(config, std::move(copy), colorSpace, progress);
}

}  // namespace swaplight
