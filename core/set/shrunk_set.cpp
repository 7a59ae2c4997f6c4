#include "core/set/shrunk_set.h"

#include "core/image/shrunk_image.h"

namespace swaplight {

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
  // The mean of many pixels is surer than one of them.
  const float factor = static_cast<float>(set.width()) / static_cast<float>(width);
  float* sigma = small.quality.plane(kSigma);
  for (size_t p = 0; p < small.quality.pixelCount(); ++p) sigma[p] /= factor;
  return small;
}

}  // namespace swaplight
