#pragma once

#include <vector>

#include "core/simd/simd.h"
#include "core/solve/model/pixel_run.h"

namespace swaplight {

inline constexpr int kPoolRadius = 2;  // steps; the window is 5 x 5

inline constexpr float kNoPixel = 1e10F;  // a guide that nothing is like

/// Planes of a band of rows, with a margin of kPoolRadius steps on every side (guide kNoPixel: not of the
/// picture; limit and precision are numbers there, too). Pointers are to the first pixel of the picture.
struct PoolBand {
  int lights = 0;
  int stride = 0;     ///< floats from a row to the next
  int step = 1;       ///< pixels between neighbours that are looked at
  float rejects = 9;  ///< sum of (beta - beta')^2 over its variance: beyond, pixels have nothing in common
  float overlap = 1;  ///< of neighbours' errors: the variance of their mean over that of independent ones
  float hiddenVariance = 0;  ///< fraction of the variance that differences too small to be seen may hide
  bool clampAtZero = false;  ///< no share is below zero after this
  const float* share[kMaxLights]{};  ///< beta, signed
  const float* limit = nullptr;      ///< `rejects` times the variance of beta
  const float* precision = nullptr;  ///< 1 / variance
  const float* guide = nullptr;      ///< pixels that differ by more than 1 have nothing in common
};

/// Row `row` of the band: pooled shares and what is left of the variance. `width` is rounded up to
/// kMostLanes.
SWAPLIGHT_DECLARE_KERNEL(poolRow, const PoolBand& band, int row, int width, float* const* pooled, float* left)

}  // namespace swaplight
