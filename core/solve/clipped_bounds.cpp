#include "core/solve/clipped_bounds.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/parallel.h"
#include "core/solve/auto/censored_light.h"

namespace swaplight {
namespace {

constexpr double kFarthest = 100;       // times what a shot that is not clipped gets
constexpr double kHardlyKnown = .5;     // sigma
constexpr double kBoundSettled = 1e-4;  // change in a sweep

using Reading = ShotSignal::Reading;

/// How a channel's light stands to what its shots show.
struct Standing {
  bool clipped = false;  ///< some shot is
  int usable = 0;        ///< shots that are not
  double share = 1;      ///< that the clipped shot gets which falls shortest of what it shows
  double told = 0;       ///< the most that shots which are not clipped get, at exposure 1
  double farthest = 0;   ///< the most that clipped ones get, at exposure 1
};

Standing standingOf(const CensoredLight& channel, const std::vector<Reading>& readings,
                    const std::vector<float>& exposure, const std::vector<double>& light) {
  Standing standing;
  standing.share = INFINITY;
  for (size_t k = 0; k < readings.size(); ++k) {
    const double gets = channel.predicted(k, light);
    double& most = readings[k].clipped ? standing.farthest : standing.told;
    most = std::max(most, gets / double(exposure[k]));
    if (!readings[k].clipped) ++standing.usable;
    if (!readings[k].clipped || !(readings[k].light > 0)) continue;
    standing.clipped = true;
    standing.share = std::min(standing.share, gets / double(readings[k].light));
  }
  return standing;
}

/// Brings a channel's light within its bounds. Returns how unsure that leaves it, 0 where nothing was done.
double keepWithin(const CensoredLight& channel, const std::vector<Reading>& readings,
                  const std::vector<float>& exposure, double modelError, std::vector<double>& light) {
  const Standing now = standingOf(channel, readings, exposure, light);
  if (!now.clipped) return 0;
  if (now.share < 1 + modelError) {
    if (now.usable >= int(light.size())) return 0;  // they determine it
    // At what is shown, it rests on that.
    if (now.share < 1 - modelError) channel.descend(light, {}, kBoundSettled);
    return kHardlyKnown;
  }
  if (now.farthest <= kFarthest * now.told) return 0;
  const double kept = std::max(kFarthest * now.told / now.farthest, 1 / now.share);
  if (!(kept < 1)) return 0;
  for (double& value : light) value *= kept;
  return kHardlyKnown;
}

}  // namespace

size_t keepWithinClippedBounds(const EstimatorContext& context, const std::vector<float>& exposure,
                               const ShotSignal& signal, double modelError, SolvedSet& set) {
  std::atomic<size_t> changed = 0;
  const auto width = size_t(set.width());
  const int rows = signal.flags().empty() ? 0 : set.height();
  parallelRows(rows, 16, [&](int begin, int end) {
    std::vector<Reading> readings(exposure.size());
    std::vector<double> light(set.contributions.size());
    for (size_t p = size_t(begin) * width; p < size_t(end) * width; ++p) {
      if ((signal.flags()[p] & kClipped) == 0) continue;
      double unsure = 0;
      for (int c = 0; c < 3; ++c) {
        for (size_t k = 0; k < readings.size(); ++k) readings[k] = signal.reading(p, int(k), c);
        for (size_t i = 0; i < light.size(); ++i) light[i] = double(set.contributions[i].plane(c)[p]);
        const CensoredLight channel(context, c, readings, modelError);
        const double own = keepWithin(channel, readings, exposure, modelError, light);
        unsure = std::max(unsure, own);
        for (size_t i = 0; own > 0 && i < light.size(); ++i)
          set.contributions[i].plane(c)[p] = float(light[i]);
      }
      if (unsure <= 0) continue;
      ++changed;
      float& sigma = set.quality.plane(kSigma)[p];
      sigma = std::max(sigma, float(unsure));
    }
  });
  return changed;
}

}  // namespace swaplight
