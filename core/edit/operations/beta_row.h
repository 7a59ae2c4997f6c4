#pragma once

#include <span>

namespace swaplight {

/// A row of pixels of one light, as a light edit sees it. All rows are as long as `beta`.
struct BetaRow {
  std::span<const float> beta;     ///< the light's share of each pixel, 0..1
  const float* blurred = nullptr;  ///< by a Gaussian of sigma = reach() / 2; of edits with a reach
  const float* map = nullptr;      ///< the light's beta map from the edit's file, for edits with one
  std::span<const float> table;    ///< what the edit's tabulate() made
};

}  // namespace swaplight
