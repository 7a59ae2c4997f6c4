#pragma once

#include "core/image/image.h"

namespace swaplight {

/// How much more often than elsewhere in the set the matte model fails around a pixel: the local share of
/// pixels whose chi-square is beyond `limit`, over that of the whole set, tempered. One plane in, one out.
void localOdds(ImageView misfit, float limit, ImageSpan odds);

}  // namespace swaplight
