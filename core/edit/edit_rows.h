#pragma once

#include <vector>

namespace swaplight {

// The arithmetic of edits on rows of pixels. A light's row is R G B apart; beta is its sum over the all-white
// picture's.

struct LightRow {
  float* r;
  float* g;
  float* b;
};
struct WhiteRow {
  const float* r;
  const float* g;
  const float* b;
};

/// beta = (r + g + b) * inverseGrey.
void betaOfRow(const LightRow& light, const float* inverseGrey, int count, float* beta);

/// The meaning "add": beta goes the way mask * (target - beta). Light that goes keeps its colour; light that
/// comes has the all-white picture's.
void addRow(const LightRow& light, const WhiteRow& white, const float* beta, const float* target,
            const float* mask, int count);

/// The meaning "share": beta of the lights `chosen` goes the way mask * (target - beta), the other lights
/// keep their proportions among each other and give or take the rest; each channel's sum over the lights
/// stays. Light that is moved keeps its colour. `beta` and `target` have a row a light; those of chosen
/// lights are read.
void shareRow(const std::vector<LightRow>& lights, const std::vector<int>& chosen,
              std::vector<std::vector<float>>& beta, std::vector<std::vector<float>>& target,
              const float* mask, int count);

}  // namespace swaplight
