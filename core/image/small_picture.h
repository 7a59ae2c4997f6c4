#pragma once

#include <cstdint>
#include <vector>

namespace swaplight {

/// A picture to be shown small, as it goes to the screen: 8-bit R G B A, sRGB codes, rows from the top
/// without gaps.
struct SmallPicture {
  int width = 0, height = 0;
  std::vector<uint8_t> rgba;
  [[nodiscard]] bool empty() const { return rgba.empty(); }
};

/// The middle of a picture at another size: as much of it as fills `width` x `height`, nothing squeezed. Both
/// at least 1; an empty picture stays empty.
[[nodiscard]] SmallPicture filling(const SmallPicture& picture, int width, int height);

}  // namespace swaplight
