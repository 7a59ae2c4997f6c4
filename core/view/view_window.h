#pragma once

#include <algorithm>
#include <cmath>

namespace swaplight {

/// Which part of a picture a viewer shows, and how large. A point of the picture p is seen at (p - left/top)
/// * zoom; pixel (0, 0) of the picture covers 0..1.
struct ViewWindow {
  double left = 0;  ///< picture coordinate at the window's left edge
  double top = 0;
  double zoom = 1;  ///< window pixels a picture pixel, > 0
  int width = 0;    ///< of the window, in pixels
  int height = 0;
  bool smooth = false;  ///< enlarged pixels are never shown as squares
  bool operator==(const ViewWindow&) const = default;

  [[nodiscard]] double pictureX(double windowX) const { return left + windowX / zoom; }
  [[nodiscard]] double pictureY(double windowY) const { return top + windowY / zoom; }
  [[nodiscard]] double windowX(double pictureX) const { return (pictureX - left) * zoom; }
  [[nodiscard]] double windowY(double pictureY) const { return (pictureY - top) * zoom; }
};

/// Whether pixels are shown as they are, enlarged ones as squares; otherwise they are interpolated: a picture
/// is looked at up to 400 %, beyond it pixels are.
[[nodiscard]] inline bool showsSquares(const ViewWindow& window) {
  return !window.smooth && (window.zoom > 4 || window.zoom == 1);
}

/// The same part of a picture, on a copy of it that is `scale` times as large and stands for it.
[[nodiscard]] inline ViewWindow windowOnCopy(const ViewWindow& window, double scale) {
  if (scale == 1) return window;
  return {window.left * scale, window.top * scale, window.zoom / scale, window.width, window.height, true};
}

/// The halved picture, 0 or more, from which a window is made: the one nearest in size.
[[nodiscard]] inline int nearestLevel(double zoom) {
  return std::max(0, static_cast<int>(std::lround(-std::log2(zoom))));
}

/// The zoom at which a whole picture is seen.
[[nodiscard]] inline double fitZoom(int pictureWidth, int pictureHeight, int width, int height) {
  return std::min(static_cast<double>(width) / std::max(1, pictureWidth),
                  static_cast<double>(height) / std::max(1, pictureHeight));
}

}  // namespace swaplight
