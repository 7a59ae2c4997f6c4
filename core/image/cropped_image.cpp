#include "core/image/cropped_image.h"

#include <algorithm>

#include "core/base/error.h"

namespace swaplight {

Image croppedImage(const Image& image, const PixelRect& crop, const std::string& name) {
  if (crop.empty() || crop.x < 0 || crop.y < 0 || crop.right() > image.width() ||
      crop.bottom() > image.height())
    throw InputError("{}: is {} x {} pixels, {},{},{},{} does not lie inside. Choose less.", name,
                     image.width(), image.height(), crop.x, crop.y, crop.width, crop.height);
  ImageSpec spec = image.spec();
  spec.width = crop.width;
  spec.height = crop.height;
  Image part(spec);
  for (int c = 0; c < image.channelCount(); ++c)
    for (int y = 0; y < crop.height; ++y)
      std::copy_n(image.view().row(c, crop.y + y) + crop.x, crop.width, part.span().row(c, y));
  return part;
}

Image placedImage(const Image& image, const PixelRect& place, int width, int height) {
  ImageSpec spec = image.spec();
  spec.width = width;
  spec.height = height;
  Image whole(spec, 0);
  for (int c = 0; c < image.channelCount(); ++c)
    for (int y = 0; y < place.height; ++y)
      std::copy_n(image.view().row(c, y), place.width, whole.span().row(c, place.y + y) + place.x);
  return whole;
}

}  // namespace swaplight
