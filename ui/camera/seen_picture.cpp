#include "ui/camera/seen_picture.h"

#include <array>
#include <mutex>

#include "core/view/window_pixels.h"

namespace swaplight {

void enlarge(SeenPicture& picture) {
  if (picture.scale <= 0 || picture.scale >= 1) return;
  const std::array<ViewLayer, 1> layers{ViewLayer{&*picture.pyramid, Rgb(1)}};
  Image large(ImageSpec::rgb(picture.width, picture.height));
  large.setColorSpace(picture.image.spec().colorSpace);
  windowLinear(layers, windowOnCopy({0, 0, 1, picture.width, picture.height}, picture.scale), large.span());
  const std::unique_lock lock(picture.mutex);
  picture.image = std::move(large);
  picture.pyramid.emplace(picture.image.view());
  picture.scale = 1;
}

}  // namespace swaplight
