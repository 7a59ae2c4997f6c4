#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace swaplight {

/// IEEE half floats as their 16 bits. Exact for every half; a float is rounded to the nearest even, too large
/// becomes infinity, NaN stays NaN. Without branches, so that loops over them vectorise.
inline float floatFromHalf(uint16_t half) {
  const uint32_t sign = (half & 0x8000U) << 16;
  const uint32_t magnitude = (half & 0x7fffU) << 13;
  const auto scaled = std::bit_cast<uint32_t>(std::bit_cast<float>(magnitude) * 0x1p112F);
  const bool notFinite = (half & 0x7c00U) == 0x7c00U;
  return std::bit_cast<float>((notFinite ? 0x7f800000U | magnitude : scaled) | sign);
}

inline uint16_t halfFromFloat(float value) {
  const auto bits = std::bit_cast<uint32_t>(value);
  const uint32_t sign = (bits >> 16) & 0x8000U;
  const uint32_t magnitude = bits & 0x7fffffffU;
  const uint32_t normal = (magnitude - (112U << 23) + 0xfffU + ((magnitude >> 13) & 1U)) >> 13;
  // Denormal: adding 0.5 leaves the value, rounded to steps of 2^-24, in the low bits.
  const uint32_t tiny = std::bit_cast<uint32_t>(std::bit_cast<float>(magnitude) + 0.5F) - 0x3f000000U;
  uint32_t half = magnitude < 0x38800000U ? tiny : normal;
  half = magnitude >= 0x477ff000U ? 0x7c00U : half;  // rounds beyond 65504
  half = magnitude > 0x7f800000U ? 0x7e00U : half;
  return static_cast<uint16_t>(half | sign);
}

/// Clamped to +-65504, what half can hold: one infinity in a file spoils every filter that a compositor puts
/// on it. NaN stays NaN.
inline float clampedToHalf(float value) {
  constexpr float kLargest = 65504;
  return value > kLargest ? kLargest : (value < -kLargest ? -kLargest : value);
}

/// The same of finite values; an infinity stays one, so that what is broken shows as that.
inline float finiteClampedToHalf(float value) {
  return std::abs(value) <= std::numeric_limits<float>::max() ? clampedToHalf(value) : value;
}

/// Whether none of the values is too bright for half.
inline bool fitsHalf(const float* values, size_t count) {
  for (size_t i = 0; i < count; ++i)
    if (values[i] != clampedToHalf(values[i])) return false;
  return true;
}

/// The value that a half-float file holds instead.
inline float roundedToHalf(float value) {
  return floatFromHalf(halfFromFloat(clampedToHalf(value)));
}

/// Whole rows.
void halfFromFloat(const float* in, uint16_t* out, size_t count);
void floatFromHalf(const uint16_t* in, float* out, size_t count);

}  // namespace swaplight
