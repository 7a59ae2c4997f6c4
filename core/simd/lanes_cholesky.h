#pragma once

#include "core/simd/lanes.h"

namespace swaplight::SWAPLIGHT_LEVEL {

/// L D L' of kLanes small symmetric positive matrices at once (Cholesky without its square roots); lower
/// triangles, packed by rows: entry (i, j), j <= i, at i (i + 1) / 2 + j. The factor's diagonal holds 1 / D.
/// kMax bounds n at compile time.
template <int kMax>
SWAPLIGHT_LANES void factorCholesky(int n, Lanes* a) {
  for (int i = 0; i < n; ++i) {
    Lanes* row = a + i * (i + 1) / 2;
    Lanes pivot = row[i];
    for (int j = 0; j < i; ++j)  // row[j] becomes L D
      for (int k = 0; k < j; ++k) row[j] -= row[k] * a[j * (j + 1) / 2 + k];
    for (int j = 0; j < i; ++j) {
      const Lanes scaled = row[j];
      row[j] *= a[j * (j + 1) / 2 + j];
      pivot -= scaled * row[j];
    }
    row[i] = reciprocal(larger(pivot, splat(1e-25F)));
  }
}

/// Solves in place with a factor of factorCholesky; what lies before `first` of x is 0.
template <int kMax>
SWAPLIGHT_LANES void solveCholesky(int n, const Lanes* factor, Lanes* x, int first = 0) {
  for (int i = first + 1; i < n; ++i)
    for (int k = first; k < i; ++k) x[i] -= factor[i * (i + 1) / 2 + k] * x[k];
  for (int i = n - 1; i >= 0; --i) {
    x[i] *= factor[i * (i + 1) / 2 + i];
    for (int k = i + 1; k < n; ++k) x[i] -= factor[k * (k + 1) / 2 + i] * x[k];
  }
}

}  // namespace swaplight::SWAPLIGHT_LEVEL
