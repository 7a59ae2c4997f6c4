#pragma once

#include "core/chart/chart_corners.h"
#include "core/image/image.h"

namespace swaplight {

/// Corners of a chart that are off by up to a fifth of a patch, moved to where the patches are most even
/// within themselves: the least variance of nine by nine places in each, over .86 of its side, relative to
/// the brightness of each channel; by steps along x and y of every corner, halved down to a hundredth of a
/// patch.
[[nodiscard]] ChartCorners refinedCorners(const Image& picture, const ChartCorners& corners);

}  // namespace swaplight
