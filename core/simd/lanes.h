#pragma once

#include <cstring>
#if defined(__SSE__)
#include <immintrin.h>
#endif

#include "core/simd/padding.h"

#ifndef SWAPLIGHT_LEVEL
#error "for kernels alone, which are compiled once for each class of processor: see core/simd/simd.h"
#endif

namespace swaplight::SWAPLIGHT_LEVEL {

/// Pixels in a register of the class of processor. Of wider vectors g++ takes comparisons and selections
/// apart into single pixels (docs/decisions/0005-lanes.md).
#if defined(__AVX512F__)
inline constexpr int kLanes = 16;
#elif defined(__AVX__)
inline constexpr int kLanes = 8;
#else
inline constexpr int kLanes = 4;
#endif
/// Vectors in a block of kMostLanes pixels. An iteration that goes on until all pixels are done asks a whole
/// block, on every processor: how good an answer is does not depend on the width of its registers.
inline constexpr int kBlockVectors = kMostLanes / kLanes;
static_assert(kMostLanes % kLanes == 0);

/// Several pixels at once: arithmetic on it is one instruction.
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));
using LaneMask = int __attribute__((vector_size(kLanes * sizeof(int))));

#define SWAPLIGHT_LANES [[gnu::always_inline]] inline

#if defined(__AVX512F__)
/// For intrinsics: g++ 12 warns of those without a mask (its bug 105593).
inline constexpr __mmask16 kAllLanes = 0xffff;
#endif

SWAPLIGHT_LANES Lanes splat(float x) {
  return Lanes{} + x;
}
SWAPLIGHT_LANES Lanes load(const float* p) {
  Lanes x;
  std::memcpy(&x, p, sizeof x);
  return x;
}
SWAPLIGHT_LANES void store(float* p, Lanes x) {
  std::memcpy(p, &x, sizeof x);
}
SWAPLIGHT_LANES Lanes select(LaneMask mask, Lanes yes, Lanes no) {
  return mask ? yes : no;
}
/// NaN in x gives `other`.
SWAPLIGHT_LANES Lanes larger(Lanes x, Lanes other) {
#if defined(__AVX512F__)
  return Lanes(_mm512_maskz_max_ps(kAllLanes, __m512(x), __m512(other)));
#elif defined(__AVX__)
  return Lanes(_mm256_max_ps(__m256(x), __m256(other)));
#else
  return x > other ? x : other;
#endif
}
SWAPLIGHT_LANES Lanes smaller(Lanes x, Lanes other) {
#if defined(__AVX512F__)
  return Lanes(_mm512_maskz_min_ps(kAllLanes, __m512(x), __m512(other)));
#elif defined(__AVX__)
  return Lanes(_mm256_min_ps(__m256(x), __m256(other)));
#else
  return x < other ? x : other;
#endif
}
/// 1 / x by a step of Newton's from a guess.
SWAPLIGHT_LANES Lanes refinedReciprocal(Lanes x, Lanes guess) {
  return guess + guess * (1 - x * guess);
}
/// 1 / x, within 6e-5 of it: for weights. Of what is not normal, it may be no number.
SWAPLIGHT_LANES Lanes roughReciprocal(Lanes x) {
#if defined(__AVX512F__)
  return Lanes(_mm512_maskz_rcp14_ps(kAllLanes, __m512(x)));
#elif defined(__AVX__)
  return refinedReciprocal(x, Lanes(_mm256_rcp_ps(__m256(x))));
#elif defined(__SSE__)
  return refinedReciprocal(x, Lanes(_mm_rcp_ps(__m128(x))));
#else
  return 1 / x;
#endif
}
/// 1 / x to the last bits or so: faster than a division where many follow each other.
SWAPLIGHT_LANES Lanes reciprocal(Lanes x) {
  return refinedReciprocal(x, roughReciprocal(x));
}
SWAPLIGHT_LANES Lanes squareRoot(Lanes x) {
  Lanes y;
  for (int l = 0; l < kLanes; ++l) y[l] = __builtin_sqrtf(x[l]);
  return y;
}
SWAPLIGHT_LANES bool any(LaneMask mask) {
#if defined(__AVX512F__)
  return _mm512_test_epi32_mask(__m512i(mask), __m512i(mask)) != 0;
#else
  long long halves[kLanes / 2];
  std::memcpy(halves, &mask, sizeof mask);
  long long found = 0;
  for (const long long half : halves) found |= half;
  return found != 0;
#endif
}

/// Natural logarithm of positive, finite, normal x; absolute error below 1e-4 (enough for evidence).
SWAPLIGHT_LANES Lanes logarithm(Lanes x) {
  LaneMask bits;
  std::memcpy(&bits, &x, sizeof bits);
  const LaneMask exponent = (bits >> 23) - 127;
  bits = (bits & 0x007fffff) | 0x3f800000;
  Lanes m;
  std::memcpy(&m, &bits, sizeof m);
  const Lanes e = __builtin_convertvector(exponent, Lanes);
  // log(m), m in 1..2, as 2 atanh((m - 1) / (m + 1)).
  const Lanes t = (m - 1) / (m + 1);
  const Lanes t2 = t * t;
  return e * 0.69314718F + 2 * t * (1 + t2 * (1.0F / 3 + t2 * (0.2F + t2 * (1.0F / 7 + t2 * (1.0F / 9)))));
}

/// exp(x), relative error below 1e-5; x below -80 gives 0, above 80 exp(80).
SWAPLIGHT_LANES Lanes exponential(Lanes x) {
  const LaneMask tiny = x < -80;
  const Lanes y = smaller(larger(x, splat(-80)), splat(80)) * 1.44269504F;
  const LaneMask whole = __builtin_convertvector(y + 256.5F, LaneMask) - 256;  // round to nearest
  const Lanes f = (y - __builtin_convertvector(whole, Lanes)) * 0.69314718F;
  const Lanes p =
      1 + f * (1 + f * (0.5F + f * (1.0F / 6 + f * (1.0F / 24 + f * (1.0F / 120 + f * (1.0F / 720))))));
  const LaneMask bits = (whole + 127) << 23;
  Lanes scale;
  std::memcpy(&scale, &bits, sizeof scale);
  return select(tiny, splat(0), p * scale);
}

}  // namespace swaplight::SWAPLIGHT_LEVEL
