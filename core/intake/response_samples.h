#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/image/image.h"
#include "core/intake/brackets.h"

namespace swaplight {

constexpr int kResponseLevels = 256;  ///< codes that a response is found for

/// The codes of a channel that pixels had in all exposures of their bracket: what a camera's response is
/// recovered from. Only of pixels whose neighbours are alike: at an edge the lens decides.
struct ResponseSamples {
  size_t length = 0;             ///< exposures of a bracket
  std::vector<uint8_t> levels;   ///< [pixel][exposure]
  std::vector<double> logTimes;  ///< [lighting][exposure]: ln of the exposure
  std::vector<int> lighting;     ///< [pixel]

  [[nodiscard]] size_t pixels() const { return lighting.size(); }
  [[nodiscard]] int level(size_t pixel, size_t exposure) const { return levels[pixel * length + exposure]; }
  [[nodiscard]] double logTime(size_t pixel, size_t exposure) const {
    return logTimes[static_cast<size_t>(lighting[pixel]) * length + exposure];
  }
  /// How many values there are of every code.
  [[nodiscard]] std::array<int, kResponseLevels> counts() const;
};

/// `codes`: pictures as their files hold them, 0..1, in brackets. About 20,000 pixels of each lighting.
[[nodiscard]] ResponseSamples responseSamples(const std::vector<Image>& codes, const Brackets& brackets,
                                              int channel);

}  // namespace swaplight
