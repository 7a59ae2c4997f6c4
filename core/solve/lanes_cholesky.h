#pragma once

#include "core/solve/lanes.h"

namespace swaplight {

/// Cholesky of sixteen small symmetric positive matrices at once; lower triangles, packed by rows: entry (i,
/// j), j <= i, at i (i + 1) / 2 + j. The factor's diagonal holds its reciprocals. kMax bounds n at compile
/// time.
template <int kMax>
SWAPLIGHT_LANES void factorCholesky(int n, Lanes* a) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) {
      Lanes sum = a[i * (i + 1) / 2 + j];
      for (int k = 0; k < j; ++k) sum -= a[i * (i + 1) / 2 + k] * a[j * (j + 1) / 2 + k];
      if (i == j)
        a[i * (i + 1) / 2 + j] = 1 / squareRoot(larger(sum, splat(1e-25F)));
      else
        a[i * (i + 1) / 2 + j] = sum * a[j * (j + 1) / 2 + j];
    }
}

/// Solves in place with a factor of factorCholesky.
template <int kMax>
SWAPLIGHT_LANES void solveCholesky(int n, const Lanes* factor, Lanes* x) {
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < i; ++k) x[i] -= factor[i * (i + 1) / 2 + k] * x[k];
    x[i] *= factor[i * (i + 1) / 2 + i];
  }
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k) x[i] -= factor[k * (k + 1) / 2 + i] * x[k];
    x[i] *= factor[i * (i + 1) / 2 + i];
  }
}

}  // namespace swaplight
