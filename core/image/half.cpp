#include "core/image/half.h"

#include "core/simd/simd.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace swaplight {
namespace {

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
  return processorLevel() >= 3;
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
