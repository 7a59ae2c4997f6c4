#pragma once

#include <array>

#include "core/chart/chart_patches.h"

namespace swaplight {

/// A place in a picture, in pixels: the middle of the top left one is 0, 0.
struct PicturePlace {
  double x = 0, y = 0;
  bool operator==(const PicturePlace&) const = default;
};

/// Where a chart lies in a picture: the outer corners of the patches dark skin, bluish green, black and
/// white.
using ChartCorners = std::array<PicturePlace, 4>;

/// From a chart to the picture and back, in perspective (the plane homography of four points).
class ChartPerspective {
 public:
  /// Throws InputError where three of the corners lie on a line, or they cross.
  explicit ChartPerspective(const ChartCorners& corners);

  [[nodiscard]] PicturePlace inPicture(const ChartPlace& chart) const;
  [[nodiscard]] ChartPlace inChart(const PicturePlace& picture) const;

 private:
  std::array<double, 9> m_picture{}, m_chart{};  // rows
};

/// The eight ways in which a chart may lie between the same four corners, four of them mirrored.
[[nodiscard]] std::array<ChartCorners, 8> arrangementsOf(const ChartCorners& corners);

}  // namespace swaplight
