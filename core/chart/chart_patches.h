#pragma once

#include <array>
#include <cstddef>

#include "core/color/rgb.h"

namespace swaplight {

// The Macbeth chart (ColorChecker Classic): 24 patches in four rows of six, dark skin at the top left, white
// at the bottom left and black at the bottom right.

inline constexpr int kChartColumns = 6;
inline constexpr int kChartRows = 4;
inline constexpr size_t kChartPatches = 24;
inline constexpr size_t kFirstGrey = 18;  ///< white to black, the last row

/// "dark skin" ... "black".
[[nodiscard]] const char* chartPatchName(size_t patch);

/// What the patch reflects, in linear Rec.709, of which {1, 1, 1} reflects all: the maker's L*a*b* of charts
/// until November 2014 (X-Rite; D50, 2 degrees), brought to D65 by Bradford. Cyan lies outside of Rec.709:
/// its red is negative. Charts differ from it by CIEDE2000 1 or so.
[[nodiscard]] const std::array<Rgb, kChartPatches>& chartReflectances();

/// The middle of a patch, in a chart whose four corner patches have their outer corners at 0,0 (dark skin),
/// 1,0 (bluish green), 1,1 (black) and 0,1 (white), and half the side of a patch there, across and down. Gaps
/// are a tenth of a patch, as OpenCV's model of the chart has them; those of single makes are up to .15.
struct ChartPlace {
  double x = 0, y = 0;
};
inline constexpr double kChartGap = .1;
inline constexpr double kChartWidth = kChartColumns + (kChartColumns - 1) * kChartGap;  ///< in patches
inline constexpr double kChartHeight = kChartRows + (kChartRows - 1) * kChartGap;
[[nodiscard]] ChartPlace chartPatchPlace(size_t patch);

}  // namespace swaplight
