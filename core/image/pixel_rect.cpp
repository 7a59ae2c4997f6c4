#include "core/image/pixel_rect.h"

#include <algorithm>
#include <cstdio>

namespace swaplight {

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  const int x = std::max(a.x, b.x);
  const int y = std::max(a.y, b.y);
  return {x, y, std::max(0, std::min(a.right(), b.right()) - x),
          std::max(0, std::min(a.bottom(), b.bottom()) - y)};
}

PixelRect enclosing(const PixelRect& a, const PixelRect& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  const int x = std::min(a.x, b.x);
  const int y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
}

std::optional<PixelRect> rectFromText(const std::string& text) {
  PixelRect rect;
  char end = 0;
  const int read = std::sscanf(text.c_str(), "%d,%d,%d,%d%c", &rect.x, &rect.y,  // NOLINT(cert-err34-c)
                               &rect.width, &rect.height, &end);
  return read == 4 ? std::optional(rect) : std::nullopt;
}

}  // namespace swaplight
