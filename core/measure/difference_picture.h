#pragma once

#include <string>
#include <vector>

#include "core/image/image.h"
#include "core/measure/difference.h"

namespace swaplight {

/// The difference of each pixel in false colour (viridis from 0, or from the smallest value for psnr, to
/// `maximum`) with a legend on its right. Pixels that are not finite are magenta. maximum 0: the 99th
/// percentile, rounded up to a friendly number. R G B, sRGB code values.
[[nodiscard]] Image drawDifferenceMap(const Difference& difference, double maximum = 0);

/// What is plotted: the whole or a part of the pictures.
struct PlottedDifferences {
  std::string name;
  const std::vector<Difference>* differences = nullptr;  ///< one a metric; the same metrics in each part
};
/// A box plot a metric, side by side, each with its own axis; in each a box for every part.
[[nodiscard]] Image drawDifferencePlot(const std::vector<PlottedDifferences>& parts);

}  // namespace swaplight
