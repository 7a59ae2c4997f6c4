#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/relight/rig.h"
#include "core/set/solved_set.h"
#include "core/view/display/display_table.h"

namespace swaplight {

/// What is to be said about a place of the relit picture: means over a square.
struct PixelProbe {
  Rgb linear{0, 0, 0};            ///< in the set's primaries
  float stops = 0;                ///< of the luminance from middle grey (0.18); -inf for black
  std::array<uint8_t, 3> code{};  ///< of the mean, through the view
  std::vector<float> shares;      ///< of the luminance, by light, ambient last; they add up to 1, or are 0
  float residual = 0;             ///< largest in the square
  float sigma = 0;                ///< largest in the square
  int flags = 0;                  ///< of any pixel in the square
};

/// Looks at `side` x `side` pixels about (x, y); what of them lies outside of the picture is left out. The
/// point itself has to lie inside.
[[nodiscard]] PixelProbe probePixels(const ColorConfig& config, const SolvedSet& set, const Rig& rig, int x,
                                     int y, int side, const DisplayTable& table, const Rgb& luminanceWeights);

}  // namespace swaplight
