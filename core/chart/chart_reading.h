#pragma once

#include <array>

#include "core/chart/chart_corners.h"
#include "core/color/rgb.h"
#include "core/image/image.h"

namespace swaplight {

/// A patch as the photograph has it.
struct PatchReading {
  Rgb mean{0, 0, 0};    ///< of the middle half of its pixels, a channel, so that dust does not count
  float clipped = 0;    ///< share of its pixels that are saturated or not finite in a channel
  Rgb spread{0, 0, 0};  ///< standard deviation of a pixel, by the middle half
  int pixels = 0;
};

using ChartReading = std::array<PatchReading, kChartPatches>;

/// The middles of the patches, half as wide and high as they are, of a picture in linear light (R G B).
/// `clipLevel`: at and above which the sensor was saturated. Throws InputError where the chart is not all
/// inside of the picture, or a patch has less than kFewestPatchPixels in it.
[[nodiscard]] ChartReading readChart(const Image& picture, float clipLevel, const ChartCorners& corners);
inline constexpr int kFewestPatchPixels = 16;

/// How much a reading looks like a chart: which part of its variance over the patches three filters of the
/// patches' reflectances explain, 0..1, the brighter channels counting more. What is no chart, or one turned
/// otherwise, has less than .5; a chart under one light more than .9.
[[nodiscard]] double chartLikeness(const ChartReading& reading);

}  // namespace swaplight
