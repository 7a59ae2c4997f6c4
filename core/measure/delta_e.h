#pragma once

#include "core/image/image.h"
#include "core/measure/lab.h"

namespace swaplight {

/// kL, kC, kH of CIEDE2000: what a difference of lightness, chroma or hue is divided by, above 0. 1 each is
/// the standard; the dissertation of 2013 takes 5:1:1, so that lightness hardly counts.
struct DeltaEWeights {
  double lightness = 1;
  double chroma = 1;
  double hue = 1;
  bool operator==(const DeltaEWeights&) const = default;
};

/// The colour difference CIEDE2000; with weights of 1 about 1 is just noticeable side by side.
/// Sharma, Wu and Dalal, "The CIEDE2000 color-difference formula: implementation notes, supplementary test
/// data, and mathematical observations", Color Research and Application 30(1), 2005.
[[nodiscard]] double deltaE2000(const Lab& x, const Lab& y, const DeltaEWeights& weights = {});

/// CIEDE2000 of every pixel of two pictures (R G B, linear Rec.709), both multiplied by `scale` and clipped
/// to 0..1 first, as a display at that exposure would show them. `out` is one plane of the same size. A pixel
/// that is not finite in either picture becomes NaN.
void deltaE2000(ImageView test, ImageView reference, float scale, ImageSpan out,
                const DeltaEWeights& weights = {});

}  // namespace swaplight
