#pragma once

#include <span>

#include "core/image/image.h"

namespace swaplight {

/// What a pixel's neighbours say of its proportions, where noise hides them: beta is shrunk toward the
/// weighted mean of its neighbourhood by an adaptive Wiener filter (Lee 1980),
///   m + s / (s + variance) (beta - m),   s = max(0, local variance of beta - expected noise)
/// so that nothing happens where the photographs are clear, and a shadow's edge, where s is large, stays.
/// `shares`: a plane a light, 0..1, sum 1. `variance`: of beta, a plane. `pooled` (a plane a light) receives
/// the shares, `left` what is left of the variance; neither may be the same memory as the input.
void poolShares(ImageView shares, ImageView variance, std::span<const ImageSpan> pooled, ImageSpan left);

/// How much more often than elsewhere in the set the matte model fails around a pixel: the local share of
/// pixels whose chi-square is beyond `limit`, over that of the whole set, tempered. One plane in, one out.
void localOdds(ImageView misfit, float limit, ImageSpan odds);

}  // namespace swaplight
