#pragma once

#include "core/image/image.h"
#include "core/measure/lab.h"

namespace swaplight {

/// The colour difference CIEDE2000 with kL = kC = kH = 1; about 1 is just noticeable side by side.
/// Sharma, Wu and Dalal, "The CIEDE2000 color-difference formula: implementation notes, supplementary test
/// data, and mathematical observations", Color Research and Application 30(1), 2005.
[[nodiscard]] double deltaE2000(const Lab& x, const Lab& y);

/// CIEDE2000 of every pixel of two pictures (R G B, linear Rec.709), both multiplied by `scale` and clipped
/// to 0..1 first, as a display at that exposure would show them. `out` is one plane of the same size. A pixel
/// that is not finite in either picture becomes NaN.
void deltaE2000(ImageView test, ImageView reference, float scale, ImageSpan out);

}  // namespace swaplight
