#pragma once

#include <cstddef>
#include <vector>

namespace swaplight {

// The arithmetic of edits on rows of pixels. A light's row is R G B apart; beta is its sum over that of
// all lights at unit white.

struct RgbRow {
  float* r;
  float* g;
  float* b;
};
struct ConstRgbRow {
  const float* r;
  const float* g;
  const float* b;
};

/// beta = (r + g + b) * inverseGrey.
void betaOfRow(const ConstRgbRow& light, const float* inverseGrey, int count, float* beta);

/// Energy mode Add: beta goes the way mask * (target - beta). Light that goes keeps its colour; light that
/// comes has the colour of the sum at unit white.
void addRow(const RgbRow& light, const ConstRgbRow& white, const float* beta, const float* target,
            const float* mask, int count);

/// Rows to work in, made once for many rows.
struct ShareScratch {
  ShareScratch(size_t lights, size_t pixels);
  std::vector<std::vector<float>> beta;    ///< a row a light
  std::vector<std::vector<float>> target;  ///< a row a light; those of chosen lights are read
  std::vector<float> chosen, others, wanted, otherFactor, otherGift, gains, potR, potG, potB;
};

/// Energy mode Redistribute: beta of the lights `chosen` goes the way mask * (target - beta), the other
/// lights keep their proportions among each other and give or take the rest; each channel's sum over the
/// lights stays. Light that is moved keeps its colour. Overwrites what is in the scratch.
void shareRow(const std::vector<RgbRow>& lights, const std::vector<int>& chosen, const float* mask, int count,
              ShareScratch& scratch);

}  // namespace swaplight
