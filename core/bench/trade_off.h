#pragma once

#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/image.h"

namespace swaplight {

/// An estimator on one still life: what it costs and how wrong it is.
struct TradeOff {
  std::string solver;
  int lights = 0;
  bool glossy = false;
  double megapixels = 0;  ///< a second, pictures in memory, on as many threads as there are
  double limit = 0;       ///< of a plain stream through as many planes
  double deltaE = 0;      ///< mean CIEDE2000 of the frame over five new lightings
  double relativeRmse = 0;
};

/// Speed against error of every estimator: the ray-cast still life (bench_picture.h) under 2, 3, 4 and 8
/// lights that change places, matte and with gloss 1, full well 20,000, read noise .002. `quick`: small, and
/// each figure from one run.
[[nodiscard]] std::vector<TradeOff> measureTradeOff(unsigned seed, bool quick, const Progress& progress = {});

/// Error over speed, matte and glossy side by side: a line an estimator through its numbers of lights, and
/// the memory's limit. R, G, B, sRGB codes.
[[nodiscard]] Image drawTradeOff(const std::vector<TradeOff>& rows);

}  // namespace swaplight
