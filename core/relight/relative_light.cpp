#include "core/relight/relative_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/check.h"
#include "core/image/shrunk_image.h"

namespace swaplight {
namespace {

/// Of the mean: what is darker says little about what falls there.
constexpr double kDark = 1e-3;

double lightOf(const Image& picture, int channel, size_t pixel) {
  return std::max(picture.plane(channel)[pixel], 0.F);
}

double meanOf(const Image& picture, int channel) {
  double sum = 0;
  for (size_t p = 0; p < picture.pixelCount(); ++p) sum += lightOf(picture, channel, p);
  return sum / static_cast<double>(picture.pixelCount());
}

void add(Image& sum, const Image& picture, const Rgb& factor) {
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < sum.pixelCount(); ++p) sum.plane(c)[p] += factor[c] * picture.plane(c)[p];
}

}  // namespace

Image relativeLight(const Image& lit, const Image& unit) {
  SWAPLIGHT_CHECK_EQ(lit.width(), unit.width());
  SWAPLIGHT_CHECK_EQ(lit.height(), unit.height());
  Image ratio(ImageSpec::rgb(lit.width(), lit.height()));
  for (int c = 0; c < 3; ++c) {
    const double mean = meanOf(unit, c), most = mean > 0 ? meanOf(lit, c) / mean : 1;
    const double dark = mean > 0 ? kDark * mean : 1;
    for (size_t p = 0; p < ratio.pixelCount(); ++p)
      ratio.plane(c)[p] =
          static_cast<float>((lightOf(lit, c, p) + dark * most) / (lightOf(unit, c, p) + dark));
  }
  return ratio;
}

Image relativeLight(const SolvedSet& set, std::span<const Rgb> factors, float ambientFactor) {
  SWAPLIGHT_CHECK_EQ(factors.size(), set.contributions.size());
  const double scale =
      std::min(1.0, static_cast<double>(kRelativeLightSide) / std::max(set.width(), set.height()));
  const int width = std::max(1, static_cast<int>(std::lround(scale * set.width())));
  const int height = std::max(1, static_cast<int>(std::lround(scale * set.height())));
  Image lit(ImageSpec::rgb(width, height), 0), unit(ImageSpec::rgb(width, height), 0);
  const auto take = [&](const Image& picture, const Rgb& factor) {
    const Image small = shrunkImage(picture, width, height);
    add(lit, small, factor);
    add(unit, small, Rgb(1));
  };
  for (size_t i = 0; i < factors.size(); ++i) take(set.contributions[i], factors[i]);
  if (set.ambient) take(*set.ambient, Rgb(ambientFactor));
  return relativeLight(lit, unit);
}

}  // namespace swaplight
