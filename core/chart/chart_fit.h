#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/chart/chart_reading.h"
#include "core/color/rgb.h"

namespace swaplight {

/// From a camera's linear R G B under one light, divided by what white is there, to linear Rec.709; rows.
/// White stays white: every row's sum is 1.
using CameraMatrix = std::array<std::array<double, 3>, 3>;

[[nodiscard]] Rgb throughCamera(const CameraMatrix& matrix, const Rgb& balanced);

struct PatchFit {
  Rgb color{0, 0, 0};    ///< linear Rec.709, as the matrix has it
  double deltaE = 0;     ///< CIEDE2000 to the chart's
  double balanced = 0;   ///< the same without the matrix, the light taken off alone
  bool clipped = false;  ///< saturated: was not used
  bool outlier = false;  ///< of less weight than a tenth: glare, a shadow, a spoiled patch
};

/// What a chart in a photograph says of the light and of the camera.
struct ChartFit {
  /// What a surface that reflects everything is in the photograph, at the chart's middle: the colour that the
  /// light has as "light_colors" of a capture. Linear, in the photograph's primaries, full scale 1.
  Rgb light{1, 1, 1};
  Rgb lightError{0, 0, 0};  ///< standard error, by how the grey patches differ
  /// Nothing where a channel of the light is too dark for one.
  std::optional<CameraMatrix> matrix;
  /// How much brighter the light is at the right edge of the chart than at the left, and below than above:
  /// -.1 is 10 % darker. It was taken off.
  double across = 0, down = 0;
  double meanDeltaE = 0, mostDeltaE = 0;  ///< CIEDE2000 of the patches that are not saturated
  double meanBalanced = 0;                ///< the mean without the matrix
  std::array<PatchFit, kChartPatches> patches{};
  std::vector<std::string> warnings;
};

/// The light by the grey patches (their robust mean ratio to what they reflect); the matrix by all patches,
/// least squares in steps of lightness (a residual over the patch's luminance to the power of 2/3, the slope
/// of CIE lightness), with Tukey's weights, white kept (Finlayson and Drew 1997); an exposure that changes
/// evenly in its logarithm over the chart, by what the others leave of the patches' luminances. In turns
/// until nothing moves. Throws InputError where too many patches are saturated or black.
[[nodiscard]] ChartFit fitChart(const ChartReading& reading);

/// "light", "light_error", "camera_matrix" (or null), "delta_e" {mean, most, balanced}, "unevenness",
/// "patches", "warnings".
[[nodiscard]] Json jsonFromChartFit(const ChartFit& fit);

}  // namespace swaplight
