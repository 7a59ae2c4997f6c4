#pragma once

#include "core/color/rgb.h"
#include "core/image/image.h"

namespace swaplight {

/// A photograph balanced by two lamps' colours alone, and the beta map that this took.
struct TwoColorBalance {
  Image picture;
  Image beta;  ///< one channel: the first lamp's share, 0..1
};

/// Without a solved set: every pixel is taken for grey, y = a l_1 + b l_2 with a, b >= 0 by least squares,
/// beta = a / (a + b), and out = y Y(I) / I w / Y(w) with I = beta l_1 + (1 - beta) l_2: scale-free, unlike
/// the projection on the line between the colours (Lindsay 2013, 6.4.3), which is right for white surfaces
/// only. A surface's own colour is partly taken for light: where surfaces are coloured and the lamps nearly
/// white, this is worse than leaving the picture alone (docs/balance.md, four times the error of a solved
/// set).
///
/// Colours in the photograph's primaries, not black and not alike (their directions differ); `white` of any
/// luminance; NaN and infinity become 0.
[[nodiscard]] TwoColorBalance balanceByTwoColors(const Image& photograph, const Rgb& first, const Rgb& second,
                                                 const Rgb& white, const Rgb& luminanceWeights);

/// Whether two colours differ enough for a share to be read from a pixel: their directions by more than a
/// degree.
[[nodiscard]] bool tellTwoLampsApart(const Rgb& first, const Rgb& second);

}  // namespace swaplight
