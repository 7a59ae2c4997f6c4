#include "core/image/orientation.h"

#include <utility>

#include "core/base/parallel.h"

namespace swaplight {

Image uprightImage(Image&& image, int exif) {
  if (exif < 2 || exif > 8) return std::move(image);
  const bool flipX = exif == 2 || exif == 3 || exif == 7 || exif == 8;
  const bool flipY = exif == 3 || exif == 4 || exif == 6 || exif == 7;
  const bool swapped = turnsBySide(exif);
  ImageSpec spec = image.spec();
  if (swapped) std::swap(spec.width, spec.height);
  Image upright(std::move(spec));
  const ImageView from = std::as_const(image).view();
  const ImageSpan to = upright.span();
  parallelRows(to.height, 16, [&](int begin, int end) {
    for (int c = 0; c < to.channels; ++c)
      for (int v = begin; v < end; ++v)
        for (int u = 0; u < to.width; ++u) {
          const int x = swapped ? v : u;
          const int y = swapped ? u : v;
          to.at(c, u, v) = from.at(c, flipX ? from.width - 1 - x : x, flipY ? from.height - 1 - y : y);
        }
  });
  return upright;
}

}  // namespace swaplight
