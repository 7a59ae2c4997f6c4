#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <vector>

#include "core/color/rgb.h"
#include "core/view/scopes/scope_sample.h"

namespace swaplight {

/// How many pixels of a sample fall onto each place of a scope. Row 0 is the top.
struct ScopeCounts {
  int width = 0;
  int height = 0;
  std::vector<uint32_t> counts;

  [[nodiscard]] uint32_t at(int x, int y) const {
    return counts[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
  }
};

/// What a waveform follows. Luma is Rec.709's, of display codes.
enum class ScopeChannel { Red, Green, Blue, Luma };

/// Display codes against the place across the picture: column x is that part of its width, the top row code
/// 255, the bottom row (the 256th) code 0. Three of them side by side are a parade.
[[nodiscard]] ScopeCounts waveform(const ScopeSample& sample, ScopeChannel channel, int columns = 512);

/// Colour difference of display codes, Y'CbCr of Rec.709: Cb to the right, Cr upwards, neutral in the middle,
/// -0.5..0.5 across.
[[nodiscard]] ScopeCounts vectorscope(const ScopeSample& sample, int side = 256);
/// Where a colour of display codes 0..1 lies in the vectorscope: x and y from 0 to 1, y downwards.
[[nodiscard]] std::array<float, 2> vectorscopePlace(const Rgb& code);
/// The direction in which skin of every colour lies, anticlockwise from Cb: the I axis of NTSC.
inline constexpr float kSkinLineDegrees = 123;

/// CIE 1931 x (0..0.8, to the right) and y (0..0.9, upwards) of linear pixels. Those too dark to have a
/// colour, below `darkest` of luminance, are left out.
[[nodiscard]] ScopeCounts chromaticityScope(const ScopeSample& sample, const glm::mat3& xyzFromRgb,
                                            int side = 256, float darkest = 1e-3F);
inline constexpr float kScopeLargestX = 0.8F, kScopeLargestY = 0.9F;

/// Counts for R, G, B and luma (luminance, where linear).
struct Histogram {
  std::array<std::vector<uint32_t>, 4> counts;
};
/// After the view: 256 display codes.
[[nodiscard]] Histogram codeHistogram(const ScopeSample& sample);
/// Before the view, over stops from middle grey (0.18). What lies outside is counted at the ends, what is not
/// positive at the lower one.
[[nodiscard]] Histogram stopsHistogram(const ScopeSample& sample, const Rgb& luminanceWeights, float lowest,
                                       float highest, int bins);
/// Before the view, over linear light from 0 to `highest`.
[[nodiscard]] Histogram linearHistogram(const ScopeSample& sample, const Rgb& luminanceWeights, float highest,
                                        int bins);

/// Adds counts to a picture of 8-bit R G B A of their size as light of a colour: brightness grows with the
/// logarithm, so that single pixels are seen beside large areas. `full`: the count that is fully bright.
void addScopeLight(const ScopeCounts& counts, const Rgb& color, float full, uint8_t* rgba);

}  // namespace swaplight
