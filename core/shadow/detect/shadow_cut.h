#pragma once

#include <opencv2/core.hpp>

#include "core/shadow/detect/shadow_sides.h"

namespace swaplight {

/// Shadow (255) cut from light (0), 8-bit, at the size of `sides`: the cut that costs least, where pixels pay
/// for a side that their level and the edges beside them speak against, and neighbours for being parted where
/// nothing looks like a border (minimum cut, Boykov and Jolly, "Interactive graph cuts", ICCV 2001).
/// `level`: of ShadowEvidence, at that size.
[[nodiscard]] cv::Mat cutShadow(const cv::Mat& level, float threshold, const ShadowSides& sides,
                                const ShadowCutTuning& tuning = {});

}  // namespace swaplight
