#include "core/chart/chart_reading.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/linear/decompositions.h"

namespace swaplight {
namespace {

constexpr double kMiddle = .25;           // of a patch, from its middle outwards
constexpr Eigen::Index kFewestSeen = 12;  // patches that are not saturated
// The middle half of a normal distribution has .6745 of its standard deviation on each side.
constexpr float kSigmaOfHalf = 1 / (2 * .6745F);

struct Box {
  int left, top, right, bottom;  // all inclusive
};

/// The pixels among which those of a patch are.
Box boxOf(const ChartPerspective& perspective, size_t patch) {
  const ChartPlace middle = chartPatchPlace(patch);
  double left = INFINITY, top = INFINITY, right = -INFINITY, bottom = -INFINITY;
  for (const double dx : {-kMiddle, kMiddle})
    for (const double dy : {-kMiddle, kMiddle}) {
      const PicturePlace corner =
          perspective.inPicture({middle.x + dx / kChartWidth, middle.y + dy / kChartHeight});
      left = std::min(left, corner.x), right = std::max(right, corner.x);
      top = std::min(top, corner.y), bottom = std::max(bottom, corner.y);
    }
  return {int(std::floor(left)), int(std::floor(top)), int(std::ceil(right)), int(std::ceil(bottom))};
}

void takeChannel(std::vector<float>& values, PatchReading& reading, int c) {
  std::sort(values.begin(), values.end());
  const size_t first = values.size() / 4, last = std::max(values.size() - first, first + 1);
  double sum = 0;
  for (size_t j = first; j < last; ++j) sum += values[j];
  reading.mean[c] = float(sum / double(last - first));
  reading.spread[c] = kSigmaOfHalf * (values[last - 1] - values[first]);
}

PatchReading readPatch(const Image& picture, float clipLevel, const ChartPerspective& perspective,
                       size_t patch) {
  const ChartPlace middle = chartPatchPlace(patch);
  const Box box = boxOf(perspective, patch);
  if (box.left < 0 || box.top < 0 || box.right >= picture.width() || box.bottom >= picture.height())
    throw InputError("the chart is not all in the picture of {} x {} pixels: its patch '{}' is outside",
                     picture.width(), picture.height(), chartPatchName(patch));
  std::array<std::vector<float>, 3> values;
  PatchReading reading;
  int lost = 0;
  for (int y = box.top; y <= box.bottom; ++y)
    for (int x = box.left; x <= box.right; ++x) {
      const ChartPlace at = perspective.inChart({double(x), double(y)});
      if (std::abs(at.x - middle.x) * kChartWidth > kMiddle ||
          std::abs(at.y - middle.y) * kChartHeight > kMiddle)
        continue;
      ++reading.pixels;
      const Rgb pixel(picture.view().at(0, x, y), picture.view().at(1, x, y), picture.view().at(2, x, y));
      const bool usable = std::isfinite(pixel.r + pixel.g + pixel.b) && pixel.r < clipLevel &&
                          pixel.g < clipLevel && pixel.b < clipLevel;
      lost += usable ? 0 : 1;
      for (int c = 0; usable && c < 3; ++c) values[size_t(c)].push_back(pixel[c]);
    }
  if (reading.pixels < kFewestPatchPixels)
    throw InputError(
        "the chart is too small: the middle of its patch '{}' has {} pixels; at least {} are needed",
        chartPatchName(patch), reading.pixels, kFewestPatchPixels);
  reading.clipped = float(lost) / float(reading.pixels);
  if (!values[0].empty())
    for (int c = 0; c < 3; ++c) takeChannel(values[size_t(c)], reading, c);
  return reading;
}

}  // namespace

ChartReading readChart(const Image& picture, float clipLevel, const ChartCorners& corners) {
  const ChartPerspective perspective(corners);
  ChartReading reading;
  for (size_t p = 0; p < kChartPatches; ++p) reading[p] = readPatch(picture, clipLevel, perspective, p);
  return reading;
}

double chartLikeness(const ChartReading& reading) {
  Eigen::MatrixXd filters(kChartPatches, 3), seen(kChartPatches, 3);
  Eigen::Index count = 0;
  for (size_t p = 0; p < kChartPatches; ++p) {
    if (reading[p].clipped > .5F) continue;
    for (int c = 0; c < 3; ++c) {
      filters(count, c) = double(chartReflectances()[p][c]);
      seen(count, c) = double(reading[p].mean[c]);
    }
    ++count;
  }
  if (count < kFewestSeen) return 0;
  filters.conservativeResize(count, 3);
  seen.conservativeResize(count, 3);
  const Eigen::MatrixXd left = seen - filters * leastSquares(filters, seen);
  const Eigen::MatrixXd spread = seen.rowwise() - seen.colwise().mean();
  const double variance = spread.squaredNorm();
  return variance > 0 ? std::max(0.0, 1 - left.squaredNorm() / variance) : 0;
}

}  // namespace swaplight
