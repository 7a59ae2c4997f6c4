#include "core/bench/tiled_set.h"

#include "core/base/parallel.h"

namespace swaplight {
namespace {

/// A position folded into 0..length - 1, there and back.
int folded(int position, int length) {
  const int at = position % (2 * length);
  return at < length ? at : 2 * length - 1 - at;
}

Image tiled(const Image& image, int width, int height) {
  ImageSpec spec = image.spec();
  spec.width = width;
  spec.height = height;
  Image out(spec);
  parallelRows(height, 16, [&](int begin, int end) {
    for (int c = 0; c < image.channelCount(); ++c)
      for (int y = begin; y < end; ++y) {
        const float* from = image.view().row(c, folded(y, image.height()));
        float* to = out.span().row(c, y);
        for (int x = 0; x < width; ++x) to[x] = from[folded(x, image.width())];
      }
  });
  return out;
}

}  // namespace

SolvedSet tiledSet(const SolvedSet& set, int width, int height) {
  SolvedSet large;
  large.capture = set.capture;
  for (const Image& contribution : set.contributions)
    large.contributions.push_back(tiled(contribution, width, height));
  large.beta = tiled(set.beta, width, height);
  if (set.ambient) large.ambient = tiled(*set.ambient, width, height);
  large.quality = tiled(set.quality, width, height);
  large.report = set.report;
  return large;
}

}  // namespace swaplight
