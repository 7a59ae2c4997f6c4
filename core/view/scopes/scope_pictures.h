#pragma once

#include <glm/mat3x3.hpp>

#include "core/view/scopes/scopes.h"

namespace swaplight {

/// A scope as 8-bit R G B A on black.
struct ScopePicture {
  int width = 0;
  int height = 0;
  std::vector<uint8_t> rgba;
};

/// Over which values a histogram before the view runs.
inline constexpr float kHistogramLowestStops = -10, kHistogramHighestStops = 6;
inline constexpr float kHistogramHighestLinear = 2;

/// Every scope of a sample.
struct ScopePictures {
  ScopePicture waveform;  ///< of luma
  ScopePicture parade;    ///< R, G, B side by side
  ScopePicture vectorscope;
  ScopePicture chromaticity;
  Histogram codes, stops, linear;
};
[[nodiscard]] ScopePictures scopePictures(const ScopeSample& sample, const glm::mat3& xyzFromRgb,
                                          const Rgb& luminanceWeights);

}  // namespace swaplight
