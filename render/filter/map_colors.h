#pragma once

#include <algorithm>

#include "core/base/parallel.h"
#include "core/image/image.h"

namespace swaplight {

/// Puts a function's value in place of every value of R, G and B.
inline void mapColors(ImageSpan image, float (*function)(float)) {
  constexpr int kRowsPerBand = 32;
  parallelRows(image.height, kRowsPerBand, [&](int begin, int end) {
    for (int c = 0; c < std::min(image.channels, 3); ++c)
      for (int y = begin; y < end; ++y)
        for (int x = 0; x < image.width; ++x) image.at(c, x, y) = function(image.at(c, x, y));
  });
}

}  // namespace swaplight
