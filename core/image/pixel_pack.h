#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace swaplight {

/// How a file stores a number.
enum class PixelType { UInt8, UInt16, UInt32, Half, Float };
[[nodiscard]] size_t bytesOf(PixelType type);
[[nodiscard]] std::string pixelTypeName(PixelType type);
/// Throws InputError that lists the known: uint8, uint16, half, float.
[[nodiscard]] PixelType pixelTypeFromName(const std::string& name);

/// Pixels as files hold them: row after row, a pixel's channels side by side, each of its own type.
struct PackedLayout {
  explicit PackedLayout(std::vector<PixelType> channelTypes);
  std::vector<PixelType> types;
  std::vector<size_t> offsets;  ///< of each channel in a pixel, bytes
  size_t pixelBytes = 0;
};

/// Where unpacked pixels go: a pointer a channel (nullptr: not wanted) to the first pixel, rows rowStride
/// apart.
struct UnpackTarget {
  std::span<float* const> planes;
  ptrdiff_t rowStride = 0;
  int width = 0;
  int height = 0;
};

/// Packed rows to planes, in parallel. `rows` holds target.height rows of `packedWidth` pixels, of which
/// those from `firstX` on are wanted. 8 and 16-bit integers are scaled to 0..1, 32-bit ones are not.
void unpackPixels(const std::byte* rows, const PackedLayout& layout, int packedWidth, int firstX,
                  const UnpackTarget& target);

/// A row of one channel on its own, packed and unpacked as the two below do.
void unpackRow(const std::byte* in, PixelType type, float* out, int width);
void packRow(const float* in, PixelType type, std::byte* out, int width);

/// Where pixels to be packed come from: a pointer a channel to the first pixel, rows rowStride apart.
struct PackSource {
  std::span<const float* const> planes;
  ptrdiff_t rowStride = 0;
  int width = 0;
  int height = 0;
};

/// Planes to packed rows, in parallel. What a type cannot hold is clamped: half to +-65504, integers to 0..1
/// and NaN to 0.
void packPixels(const PackSource& source, const PackedLayout& layout, std::byte* rows);

}  // namespace swaplight
