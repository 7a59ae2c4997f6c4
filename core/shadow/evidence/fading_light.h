#pragma once

#include <opencv2/core.hpp>

#include "core/shadow/evidence/shadow_tuning.h"

namespace swaplight {

/// Does a light end at a shadow that is cast, or does it fade out by itself where the surface turns away?
/// Float pictures of the ratio's size.
struct FadingLight {
  cv::Mat around;  ///< the ratio's mean over a wide window
  cv::Mat cast;    ///< where the ratio is known, 0: it fades towards there, 1: it is what it is around
  cv::Mat beyond;  ///< beyond what is known: 1 where the shadow nearby is cast, 0 where the light has faded
};

/// `ratio` (of the light to the others) is known where `fixed` (8-bit); means do not cross the guide's edges
/// (Gastal and Oliveira 2011). All of it is smooth, and looked at in a smaller picture.
[[nodiscard]] FadingLight fadingLight(const cv::Mat& ratio, const cv::Mat& fixed, const cv::Mat& guide,
                                      const ShadowTuning& tuning);

}  // namespace swaplight
