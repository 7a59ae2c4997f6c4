#include "core/image/half.h"

#include <bit>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace swaplight {
namespace {

uint16_t halfFromFloat(float value) {
  const uint32_t bits = std::bit_cast<uint32_t>(value);
  const uint32_t sign = bits >> 16 & 0x8000;
  const uint32_t magnitude = bits & 0x7fffffff;
  uint32_t half = 0;
  if (magnitude > 0x7f800000) {
    half = 0x7e00;
  } else if (magnitude >= 0x477ff000) {  // rounds beyond 65504
    half = 0x7c00;
  } else if (magnitude >= 0x38800000) {
    const uint32_t rebiased = magnitude - 0x38000000;
    half = (rebiased + 0xfff + (rebiased >> 13 & 1)) >> 13;
  } else {
    // Denormal: adding 0.5 leaves the value, rounded to steps of 2^-24, in the low bits.
    half = std::bit_cast<uint32_t>(std::bit_cast<float>(magnitude) + 0.5F) - std::bit_cast<uint32_t>(0.5F);
  }
  return static_cast<uint16_t>(sign | half);
}

float floatFromHalf(uint16_t half) {
  const uint32_t sign = static_cast<uint32_t>(half & 0x8000) << 16;
  const uint32_t magnitude = half & 0x7fff;
  uint32_t bits = 0;
  if (magnitude >= 0x7c00)
    bits = magnitude << 13 | 0x7f800000;
  else
    bits = std::bit_cast<uint32_t>(std::bit_cast<float>(magnitude << 13) * 0x1p112F);
  return std::bit_cast<float>(sign | bits);
}

#if defined(__x86_64__)
// By hand, because g++ 12 does not vectorise conversions to and from half.
__attribute__((target("avx2,f16c"))) size_t halfFromFloatVector(const float* in, uint16_t* out,
                                                                size_t count) {
  size_t i = 0;
  for (; i + 8 <= count; i += 8)
    _mm_storeu_si128(reinterpret_cast<__m128i*>(out + i),
                     _mm256_cvtps_ph(_mm256_loadu_ps(in + i), _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC));
  return i;
}

__attribute__((target("avx2,f16c"))) size_t floatFromHalfVector(const uint16_t* in, float* out,
                                                                size_t count) {
  size_t i = 0;
  for (; i + 8 <= count; i += 8)
    _mm256_storeu_ps(out + i, _mm256_cvtph_ps(_mm_loadu_si128(reinterpret_cast<const __m128i*>(in + i))));
  return i;
}

bool hasVector() {
  // Every processor with AVX2 has F16C too; clang 14 cannot ask for the latter.
  static const bool has = __builtin_cpu_supports("avx2");
  return has;
}
#else
size_t halfFromFloatVector(const float*, uint16_t*, size_t) {
  return 0;
}
size_t floatFromHalfVector(const uint16_t*, float*, size_t) {
  return 0;
}
bool hasVector() {
  return false;
}
#endif

}  // namespace

void halfFromFloat(const float* in, uint16_t* out, size_t count) {
  size_t i = hasVector() ? halfFromFloatVector(in, out, count) : 0;
  for (; i < count; ++i) out[i] = halfFromFloat(in[i]);
}

void floatFromHalf(const uint16_t* in, float* out, size_t count) {
  size_t i = hasVector() ? floatFromHalfVector(in, out, count) : 0;
  for (; i < count; ++i) out[i] = floatFromHalf(in[i]);
}

}  // namespace swaplight
