#pragma once

#include "core/image/image.h"
#include "core/solve/auto/auto_tuning.h"

namespace swaplight {

/// How much more often than elsewhere in the set the matte model fails around a pixel: the local share of
/// pixels whose chi-square, with this freedom, is too large, over that of the whole set, tempered. One plane
/// in, one out.
void localOdds(ImageView misfit, float freedom, const NeighbourhoodTuning& tuning, ImageSpan odds);

}  // namespace swaplight
