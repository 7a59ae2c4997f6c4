#pragma once

#include <tuple>
#include <utility>

namespace swaplight {

/// What steers the search for what moved between the shots (moved_pixels.h). What changing a value costs:
/// scripts/make_ablation solve --only motion.
struct MotionTuning {
  float minMisfit = 4;      ///< residual of pixels that are looked at
  float impossible = 5;     ///< root of chi-square that no light explains, for one degree of freedom
  float colorError = .02F;  ///< relative: light colours are known no better
  int window = 9;           ///< pixels across
  double minDensity = .2;   ///< of the window that no light explains
  int smallestArea = 40;    ///< pixels

  static constexpr auto fields() {
    using T = MotionTuning;
    return std::tuple{std::pair{"min_misfit", &T::minMisfit},   std::pair{"impossible", &T::impossible},
                      std::pair{"color_error", &T::colorError}, std::pair{"window", &T::window},
                      std::pair{"min_density", &T::minDensity}, std::pair{"smallest_area", &T::smallestArea}};
  }
};

}  // namespace swaplight
