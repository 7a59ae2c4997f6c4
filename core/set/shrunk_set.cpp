#include "core/set/shrunk_set.h"

#include <algorithm>
#include <cmath>

#include "core/image/shrunk_image.h"

namespace swaplight {
namespace {

/// What standard errors are told of, a pixel.
float greyAt(const Image& sum, size_t p) {
  return (sum.plane(0)[p] + sum.plane(1)[p] + sum.plane(2)[p]) / 3;
}

/// A set's standard errors at a smaller size. They are told relative to a pixel's light, of which a dark one
/// has next to none: what is averaged is the error itself. The mean of many pixels is surer than one of them,
/// but for those no lighter than their error: most of their light is noise that could not be negative, and
/// stays.
void shrinkErrors(const SolvedSet& set, SolvedSet& small) {
  Image error(ImageSpec{set.width(), set.height(), {"sigma"}, "data"});
  const float* relative = set.quality.plane(kSigma);
  const Image sum = sumAtUnitWhite(set);
  for (size_t p = 0; p < error.pixelCount(); ++p) {
    const float one = relative[p] * greyAt(sum, p);
    error.plane(0)[p] = std::isfinite(one) ? one : 0;  // no light at all may have no error that can be told
  }
  const Image mean = shrunkImage(error, small.width(), small.height());
  const float surer = static_cast<float>(small.width()) / static_cast<float>(set.width());
  const Image smallSum = sumAtUnitWhite(small);
  float* sigma = small.quality.plane(kSigma);
  for (size_t p = 0; p < mean.pixelCount(); ++p) {
    const float light = greyAt(smallSum, p);
    const float one = light > 0 ? mean.plane(0)[p] / light : sigma[p];  // of one of them
    sigma[p] = one * std::lerp(surer, 1.F, std::min(one, 1.F));
  }
}

}  // namespace

SolvedSet shrunkSet(const SolvedSet& set, int width, int height, const Progress& progress) {
  SolvedSet small;
  small.capture = set.capture;
  for (const Image& contribution : set.contributions) {
    progress.update(0, "shrinking the set");
    small.contributions.push_back(shrunkImage(contribution, width, height));
  }
  for (const Image& highlight : set.highlights)
    small.highlights.push_back(shrunkImage(highlight, width, height));
  if (set.ambient) small.ambient = shrunkImage(*set.ambient, width, height);
  updateBeta(small);
  keepHighlightsInLights(small);
  if (set.quality.empty()) return small;
  small.quality = shrunkImage(set.quality, width, height);
  shrinkErrors(set, small);
  return small;
}

}  // namespace swaplight
