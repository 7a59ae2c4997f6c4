#include "core/chart/chart_refinement.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace swaplight {
namespace {

constexpr int kPlaces = 9;                          // across and down a patch
constexpr double kReach = .43;                      // of a patch, from its middle
constexpr double kFirstStep = .1, kLastStep = .01;  // patches
constexpr int kMostMoves = 200;
constexpr double kOutside = 1e6;

/// The mean of the channels' variances within patches, over their mean squares.
double unevenness(const Image& picture, const ChartCorners& corners) {
  try {
    const ChartPerspective perspective(corners);
    std::array<double, 3> variance{}, square{};
    for (size_t p = 0; p < kChartPatches; ++p) {
      const ChartPlace middle = chartPatchPlace(p);
      std::array<double, 3> sum{}, squares{};
      for (int j = 0; j < kPlaces * kPlaces; ++j) {
        const double dx = kReach * (2.0 * (j % kPlaces) / (kPlaces - 1) - 1) / kChartWidth;
        const double dy = kReach * (2.0 * double(j / kPlaces) / (kPlaces - 1) - 1) / kChartHeight;
        const PicturePlace at = perspective.inPicture({middle.x + dx, middle.y + dy});
        const auto x = int(std::lround(at.x)), y = int(std::lround(at.y));
        if (x < 0 || y < 0 || x >= picture.width() || y >= picture.height()) return kOutside;
        for (int c = 0; c < 3; ++c) {
          const float value = picture.view().at(c, x, y);
          const double usable = std::isfinite(value) ? double(value) : 0;
          sum[size_t(c)] += usable, squares[size_t(c)] += usable * usable;
        }
      }
      for (size_t c = 0; c < 3; ++c) {
        variance[c] += squares[c] - sum[c] * sum[c] / (kPlaces * kPlaces);
        square[c] += squares[c];
      }
    }
    double mean = 0;
    for (size_t c = 0; c < 3; ++c) mean += square[c] > 0 ? variance[c] / square[c] / 3 : 0;
    return mean;
  } catch (const InputError&) {
    return kOutside;
  }
}

/// Patches are about this wide, in pixels.
double patchPixels(const ChartCorners& corners) {
  return std::hypot(corners[1].x - corners[0].x, corners[1].y - corners[0].y) / kChartWidth;
}

}  // namespace

ChartCorners refinedCorners(const Image& picture, const ChartCorners& corners) {
  ChartCorners best = corners;
  double least = unevenness(picture, best);
  const double patch = patchPixels(corners);
  int moves = 0;
  for (double step = kFirstStep; step > kLastStep;) {
    bool moved = false;
    for (int j = 0; j < 16; ++j) {
      ChartCorners next = best;
      PicturePlace& corner = next[size_t(j / 4)];
      (j % 2 == 0 ? corner.x : corner.y) += (j % 4 < 2 ? step : -step) * patch;
      if (const double one = unevenness(picture, next); one < least) {
        best = next, least = one, moved = true;
      }
    }
    if (!moved || ++moves > kMostMoves) step /= 2;
  }
  return best;
}

}  // namespace swaplight
