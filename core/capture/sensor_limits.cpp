#include "core/capture/sensor_limits.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

#include "core/base/parallel.h"
#include "core/simd/simd.h"

namespace swaplight {
namespace {

constexpr int kBandRows = 64;        // rows
constexpr float kPileFrom = 0.999F;  // of the largest value: saturated pixels differ by their read noise
constexpr float kFullScale = 1e-4F;  // how near to 1 a largest value is full scale
// A pile, see sensor_limits.h: so many samples from kPileFrom on, and no less than this part of those between
// kBelowPile and it. Highlights that fade evenly would have (1 - .999) / (.999 - .95), a fiftieth.
constexpr size_t kLeastPile = 16;
constexpr size_t kPilePart = 4;  // a quarter
constexpr float kBelowPile = 0.95F;
constexpr int kPiledShots = 2;  // a lamp that is brightest in one shot only is no limit of the sensor
// Of a step of 16 bits: how far a value may lie from one of fewer bits that was rounded to 16; half a step,
// and a tenth of that for the arithmetic of float.
constexpr float kCodingTolerance = 0.55F;
constexpr float kLargestFloat = std::numeric_limits<float>::max();

SWAPLIGHT_SIMD(PixelCounts, countRange,
               (const float* r, const float* g, const float* b, size_t count, float lowest),
               (r, g, b, count, lowest)) {
  uint32_t notFinite = 0;
  uint32_t negative = 0;
  float largest = 0;
  for (size_t p = 0; p < count; ++p) {
    const float low = std::min(r[p], std::min(g[p], b[p]));
    const float high = std::max(r[p], std::max(g[p], b[p]));
    const float sum = std::abs(r[p]) + std::abs(g[p]) + std::abs(b[p]);  // NaN where any is
    const bool finite = sum <= kLargestFloat;
    notFinite += finite ? 0U : 1U;
    negative += finite && low < lowest ? 1U : 0U;
    largest = finite && high > largest ? high : largest;
  }
  return {notFinite, negative, largest};
}

struct Pile {
  size_t at = 0;
  size_t below = 0;
};

SWAPLIGHT_SIMD(Pile, pileIn, (const float* values, size_t count, float level), (values, count, level)) {
  const float from = level * kPileFrom;
  const float lower = level * kBelowPile;
  uint32_t at = 0;
  uint32_t below = 0;
  for (size_t p = 0; p < count; ++p) {
    at += values[p] >= from && values[p] <= level ? 1U : 0U;
    below += values[p] >= lower && values[p] < from ? 1U : 0U;
  }
  return {at, below};
}

bool hasPile(const Image& image, float level) {
  std::atomic<size_t> at = 0;
  std::atomic<size_t> below = 0;
  parallelRows(image.height(), kBandRows, [&](int begin, int end) {
    const size_t first = static_cast<size_t>(begin) * static_cast<size_t>(image.width());
    const size_t count = static_cast<size_t>(end - begin) * static_cast<size_t>(image.width());
    for (int c = 0; c < 3; ++c) {
      const Pile pile = pileIn(image.plane(c) + first, count, level);
      at += pile.at;
      below += pile.below;
    }
  });
  return at >= kLeastPile && at * kPilePart >= below;
}

/// True where every value is one of 2^bits levels, to half a step of 16 bits.
bool isCodedWith(const Image& image, int bits) {
  const auto levels = static_cast<float>((1 << bits) - 1);
  const float tolerance = kCodingTolerance * levels / 65535.0F;
  for (int c = 0; c < image.channelCount(); ++c)
    for (size_t p = 0; p < image.pixelCount(); ++p) {
      const float level = image.plane(c)[p] * levels;
      if (std::abs(level - std::round(level)) > tolerance) return false;
    }
  return true;
}

}  // namespace

PixelCounts countPixels(const Image& image, float lowest) {
  PixelCounts total;
  std::mutex mutex;
  parallelRows(image.height(), kBandRows, [&](int begin, int end) {
    const size_t first = static_cast<size_t>(begin) * static_cast<size_t>(image.width());
    const size_t count = static_cast<size_t>(end - begin) * static_cast<size_t>(image.width());
    const PixelCounts part =
        countRange(image.plane(0) + first, image.plane(1) + first, image.plane(2) + first, count, lowest);
    const std::lock_guard lock(mutex);
    total.notFinite += part.notFinite;
    total.negative += part.negative;
    total.largest = std::max(total.largest, part.largest);
  });
  return total;
}

float floatClipLevel(std::span<const Image> shots, std::span<const PixelCounts> counts) {
  constexpr float kNone = std::numeric_limits<float>::infinity();
  float largest = 0;
  for (const PixelCounts& count : counts) largest = std::max(largest, count.largest);
  if (std::abs(largest - 1) <= kFullScale) return std::min(largest, 1.0F);
  if (largest <= 0) return kNone;
  const auto piles =
      std::count_if(shots.begin(), shots.end(), [&](const Image& shot) { return hasPile(shot, largest); });
  return piles >= kPiledShots ? largest * kPileFrom : kNone;
}

int codingBits(const Image& image, int storedBits) {
  if (storedBits != 16) return storedBits;
  for (const int bits : {8, 10, 12, 14})
    if (isCodedWith(image, bits)) return bits;
  return storedBits;
}

}  // namespace swaplight
