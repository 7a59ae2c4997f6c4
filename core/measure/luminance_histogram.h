#pragma once

#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/image/image.h"
#include "core/plot/plot.h"

namespace swaplight {

/// A linear picture's luminance in stops from middle grey (log2(Y / 0.18)).
struct LuminanceHistogram {
  double low = -12, high = 12;  ///< stops: where the first bin begins, where the last one ends
  std::vector<double> share;    ///< of the picture's pixels, a bin each quarter of a stop
  double black = 0;             ///< share of the pixels that are darker than `low`, or 0 and below
  double bright = 0;            ///< brighter than `high`
  double median = 0;            ///< stops; of the pixels above 0
};

/// Throws InputError where the picture's colour space is not known.
[[nodiscard]] LuminanceHistogram luminanceHistogram(const Image& picture);

/// Histograms over one another: stops from middle grey against per cent of the pixels.
struct NamedHistogram {
  std::string name;
  LuminanceHistogram histogram;
};
[[nodiscard]] Json jsonFromHistogram(const LuminanceHistogram& histogram);
[[nodiscard]] Image drawLuminanceHistograms(const std::vector<NamedHistogram>& histograms,
                                            PlotSize size = {});

}  // namespace swaplight
