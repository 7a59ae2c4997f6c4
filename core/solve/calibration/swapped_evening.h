#pragma once

#include <array>
#include <cmath>

#include "core/capture/capture.h"
#include "core/color/rgb.h"
#include "core/solve/model/unknown_color.h"

namespace swaplight {

/// What the two photographs of a swap are multiplied by, a channel, to be of one exposure and under lamps of
/// one white. With u^2 = l1 / l2 of the known gel in either lamp, y2 u is y2 under two lamps of the geometric
/// mean.
struct Evening {
  std::array<Rgb, 2> factor;
  Rgb known{1};
  Evening(const Capture& capture, const SwappedColor& swapped) {
    std::array<Rgb, 2> given;
    for (size_t j = 0; j < 2; ++j) {
      const Shot& shot = capture.shots[size_t(swapped.shots[j])];
      given[j] = *shot.lightColors[size_t(swapped.lights[j])];
      factor[j] = Rgb(std::exp2(-shot.exposureStops));
    }
    for (int c = 0; c < 3; ++c) {
      known[c] = std::sqrt(given[0][c] * given[1][c]);
      factor[1][c] *= std::sqrt(given[0][c] / given[1][c]);
    }
  }
};

}  // namespace swaplight
