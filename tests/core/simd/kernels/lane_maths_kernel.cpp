#include "tests/core/simd/kernels/lane_maths_kernel.h"

#include "core/simd/lanes.h"
#include "core/simd/lanes_cholesky.h"

namespace swaplight::test::SWAPLIGHT_LEVEL {

using namespace swaplight::SWAPLIGHT_LEVEL;

void logarithms(const float* in, float* out, int count) {
  for (int at = 0; at < count; at += kLanes) store(out + at, logarithm(load(in + at)));
}

void exponentials(const float* in, float* out, int count) {
  for (int at = 0; at < count; at += kLanes) store(out + at, exponential(load(in + at)));
}

void squareRoots(const float* in, float* out, int count) {
  for (int at = 0; at < count; at += kLanes) store(out + at, squareRoot(load(in + at)));
}

void anyPositive(const float* in, bool* found) {
  *found = false;
  for (int at = 0; at < kMostLanes; at += kLanes) *found |= any(load(in + at) > 0);
}

void solveSystems(int n, float* a, float* x) {
  Lanes matrix[kLargestSystem * (kLargestSystem + 1) / 2];
  Lanes side[kLargestSystem];
  for (int at = 0; at < kMostLanes; at += kLanes) {
    for (int e = 0; e < n * (n + 1) / 2; ++e) matrix[e] = load(a + e * kMostLanes + at);
    for (int i = 0; i < n; ++i) side[i] = load(x + i * kMostLanes + at);
    factorCholesky<kLargestSystem>(n, matrix);
    solveCholesky<kLargestSystem>(n, matrix, side);
    for (int e = 0; e < n * (n + 1) / 2; ++e) store(a + e * kMostLanes + at, matrix[e]);
    for (int i = 0; i < n; ++i) store(x + i * kMostLanes + at, side[i]);
  }
}

}  // namespace swaplight::test::SWAPLIGHT_LEVEL
