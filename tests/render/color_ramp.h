#pragma once

#include <cmath>

#include "core/image/image.h"
#include "core/view/view_window.h"
#include "render/gl/pixel_transfer.h"
#include "render/gl/tiled_texture.h"

namespace swaplight {

/// From black to beyond white, from grey to saturated, over the whole picture.
inline Image colorRamp(int width, int height) {
  Image image(ImageSpec::rgb(width, height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float level = 2.5F * static_cast<float>(x * x) / static_cast<float>(width * width);
      const float hue = static_cast<float>(y) / static_cast<float>(height);
      for (int c = 0; c < 3; ++c)
        image.span().at(c, x, y) =
            level * (0.6F + 0.4F * std::cos(6.2832F * (hue + static_cast<float>(c) / 3)));
    }
  return image;
}

inline TiledTexture uploaded(const Image& image, int maxSide = 4096) {
  TiledTexture picture(image.width(), image.height(), maxSide);
  updatePicture(picture, image.view(), 0, 0);
  return picture;
}

inline ViewWindow wholeOf(const Image& image) {
  return {0, 0, 1, image.width(), image.height()};
}

}  // namespace swaplight
