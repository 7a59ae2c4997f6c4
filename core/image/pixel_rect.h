#pragma once

namespace swaplight {

/// Pixels x .. right() - 1, y .. bottom() - 1 of a picture.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
  [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
  [[nodiscard]] int right() const { return x + width; }
  [[nodiscard]] int bottom() const { return y + height; }
  [[nodiscard]] PixelRect grown(int by) const { return {x - by, y - by, width + 2 * by, height + 2 * by}; }
  bool operator==(const PixelRect&) const = default;
};

}  // namespace swaplight
