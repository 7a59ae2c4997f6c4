#include "core/solve/denoise.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/solve/auto/share_pooling.h"

namespace swaplight {
namespace {

/// A plane of an image as pooling takes it.
Image plane(const ImageSpec& like) {
  ImageSpec spec = like;
  spec.channels = {"plane"};
  return Image(spec);
}

/// The root of the sum, whose noise is the same everywhere; and the variance of beta that is a pixel's own.
void fillPlanes(const SolvedSet& set, const EstimatorContext& context, Image& guide, Image& variance) {
  float color = 0;
  for (const Rgb& c : context.lighting.colors)
    color += (c.r + c.g + c.b) / (3 * float(context.lighting.colors.size()));
  const float* sigma = set.quality.plane(kSigma);
  for (size_t p = 0; p < guide.pixelCount(); ++p) {
    float sum = 0;
    for (const Image& t : set.contributions) sum += (t.plane(0)[p] + t.plane(1)[p] + t.plane(2)[p]) / 3;
    guide.plane(0)[p] = std::sqrt(sum);
    const float signal = color * sum;
    const float own = context.noise.constant + context.noise.linear * signal;
    const float all = own + context.noise.square * signal * signal;
    variance.plane(0)[p] = sigma[p] * sigma[p] * (all > 0 ? own / all : 1);
  }
}

}  // namespace

void denoiseGuided(SolvedSet& set, const EstimatorContext& context, int radius) {
  const int lights = set.lightCount();
  if (lights < 2) return;
  const int height = set.height();
  const int width = set.width();
  Image guide = plane(set.beta.spec());
  Image variance = plane(set.beta.spec());
  fillPlanes(set, context, guide, variance);
  Image smooth = set.beta.clone();
  Image other(set.beta.spec());
  Image left = plane(set.beta.spec());
  const float step = guideStep(guide.view(), context.noise);
  for (int reach = 1; 2 * reach <= radius; reach *= 2) {
    poolShares(planesOf(smooth), variance.view(), guide.view(),
               {.step = reach, .rejectChi2 = 4, .guideStep = step, .clampAtZero = 4 * reach > radius},
               planesOf(other), left.span());
    std::swap(smooth, other);
    std::swap(variance, left);
  }

  parallelRows(height, 32, [&](int begin, int end) {
    std::vector<float> after(static_cast<size_t>(lights));
    for (size_t p = size_t(begin) * size_t(width); p < size_t(end) * size_t(width); ++p) {
      float total = 0;
      for (size_t i = 0; i < after.size(); ++i) {
        after[i] = smooth.plane(int(i))[p];
        total += after[i];
      }
      if (!(total > 0)) continue;
      for (int c = 0; c < 3; ++c) {
        float sum = 0;
        for (const Image& t : set.contributions) sum += t.plane(c)[p];
        float moved = 0;
        for (size_t i = 0; i < after.size(); ++i) {
          float& t = set.contributions[i].plane(c)[p];
          t = std::max(t + (after[i] / total - set.beta.plane(int(i))[p]) * sum, 0.0F);
          moved += t;
        }
        if (moved > 0)
          for (Image& t : set.contributions) t.plane(c)[p] *= sum / moved;
      }
    }
  });
}

}  // namespace swaplight
