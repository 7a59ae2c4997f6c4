#include "core/intake/shot_thumbnail.h"

#include <algorithm>
#include <cmath>

#include "core/base/quantile.h"
#include "core/color/srgb.h"

namespace swaplight {
namespace {

constexpr float kBrightPart = 0.99F;  ///< the quantile of the brightest shot that is shown at kBright
constexpr float kBright = 0.7F;       ///< linear light of the screen: leaves half a stop for highlights

/// The mean over the pixels that a pixel of the thumbnail covers; broken ones are left out.
Image shrunk(const Image& shot, int width, int height) {
  Image small(ImageSpec::rgb(width, height), 0);
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const int left = x * shot.width() / width, right = std::max(left + 1, (x + 1) * shot.width() / width);
        const int top = y * shot.height() / height,
                  bottom = std::max(top + 1, (y + 1) * shot.height() / height);
        float sum = 0;
        int count = 0;
        for (int row = top; row < bottom; ++row)
          for (int column = left; column < right; ++column)
            if (const float value = shot.view().at(c, column, row); std::isfinite(value)) {
              sum += value;
              ++count;
            }
        small.span().at(c, x, y) = count > 0 ? std::max(0.0F, sum / static_cast<float>(count)) : 0;
      }
  return small;
}

float brightPartOf(const Image& image) {
  std::vector<float> values;
  for (int c = 0; c < 3; ++c)
    values.insert(values.end(), image.plane(c), image.plane(c) + image.pixelCount());
  return quantile(std::span(values), kBrightPart);
}

}  // namespace

std::vector<SmallPicture> shotThumbnails(const CapturePixels& pixels, int width, int height) {
  const double scale = std::min(
      {1.0, static_cast<double>(width) / pixels.width(), static_cast<double>(height) / pixels.height()});
  const int w = std::max(1, static_cast<int>(pixels.width() * scale));
  const int h = std::max(1, static_cast<int>(pixels.height() * scale));
  std::vector<Image> small;
  float brightest = 1e-6F;
  for (const Image& shot : pixels.shots) {
    small.push_back(shrunk(shot, w, h));
    brightest = std::max(brightest, brightPartOf(small.back()));
  }
  std::vector<SmallPicture> thumbnails;
  for (const Image& image : small) {
    SmallPicture thumbnail{w, h, std::vector<uint8_t>(4 * image.pixelCount(), 255)};
    for (size_t p = 0; p < image.pixelCount(); ++p) {
      const Rgb codes = srgbFromLinear(Rgb(image.plane(0)[p], image.plane(1)[p], image.plane(2)[p]) *
                                       (kBright / brightest));
      for (int c = 0; c < 3; ++c)
        thumbnail.rgba[4 * p + static_cast<size_t>(c)] =
            static_cast<uint8_t>(std::lround(255 * std::clamp(codes[c], 0.0F, 1.0F)));
    }
    thumbnails.push_back(std::move(thumbnail));
  }
  return thumbnails;
}

}  // namespace swaplight
