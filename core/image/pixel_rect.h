#pragma once

#include <optional>
#include <string>

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

[[nodiscard]] PixelRect intersection(const PixelRect& a, const PixelRect& b);
/// The smallest rectangle that holds both; an empty one counts for nothing.
[[nodiscard]] PixelRect enclosing(const PixelRect& a, const PixelRect& b);

/// "X,Y,WIDTH,HEIGHT"; nothing for any other text.
[[nodiscard]] std::optional<PixelRect> rectFromText(const std::string& text);

}  // namespace swaplight
