#pragma once

#include <span>

#include "core/image/image.h"
#include "core/image/io/image_io.h"

namespace swaplight {

/// What only a scan over a shot's pixels tells.
struct PixelCounts {
  size_t notFinite = 0;  ///< pixels with a NaN or an infinity in a channel
  size_t negative = 0;   ///< finite pixels below `lowest` in a channel
  float largest = 0;     ///< finite value of any channel
};
[[nodiscard]] PixelCounts countPixels(const Image& image, float lowest);

/// The level at and above which the sensor of these float shots was saturated; infinity where nothing tells.
/// Files do not say it, but saturated pixels pile up on one value, which is the same in every shot:
/// - the largest value of all shots is 1 (to 0.01 %): full scale by definition, 1;
/// - two or more shots have a pile at the largest value of all shots (to 0.1 %): 0.1 % below it. A pile is 16
/// samples or
///   more, and at least a quarter as many as lie in the 5 % below: smooth highlights, even quantised to half,
///   have a hundredth.
/// A picture of flat patches has no pile shared by its shots, because the light colours differ.
[[nodiscard]] float floatClipLevel(std::span<const Image> shots, std::span<const PixelCounts> counts);

/// The bits that integers were really coded with: 10-bit values are kept in 16-bit files, and so on. `image`
/// holds the values as stored, 0..1.
[[nodiscard]] int codingBits(const Image& image, int storedBits);

}  // namespace swaplight
