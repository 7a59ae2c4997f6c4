#include "core/solve/set_color_space.h"

#include <algorithm>

#include "core/color/chromaticities.h"
#include "core/color/color_config.h"
#include "core/error.h"

namespace swaplight {
namespace {

void convert(Image& picture, const std::string& colorSpace) {
  ColorConfig::current().convert(picture.span(), picture.spec().colorSpace, colorSpace);
  picture.setColorSpace(colorSpace);
  for (int c = 0; c < 3; ++c)
    std::transform(picture.plane(c), picture.plane(c) + picture.pixelCount(), picture.plane(c),
                   [](float v) { return std::max(v, 0.0F); });
}

}  // namespace

void checkSetColorSpace(const std::string& colorSpace) {
  if (!chromaticitiesOf(colorSpace))
    throw InputError(
        "the colour space {} is none that a set can be kept in: give lin_rec709, acescg or aces2065_1",
        colorSpace);
}

SolvedSet inColorSpace(SolvedSet set, const std::string& colorSpace) {
  checkSetColorSpace(colorSpace);
  for (Image& contribution : set.contributions) convert(contribution, colorSpace);
  if (set.ambient) convert(*set.ambient, colorSpace);
  return set;
}

}  // namespace swaplight
