#pragma once

#include "core/edit/mask/mask_ground.h"

namespace swaplight {

/// Where the set as solved is like the shape's place: each pixel averaged with its neighbours (3 x 3) against
/// the mean of 5 x 5 at the place. By colour: the largest difference of the cube roots of R, G, B of the
/// all-white picture, which are about as the eye sees them; by share: the largest difference of a light's
/// proportion. Specks of a few pixels are left out. Throws InputError where the place is outside.
[[nodiscard]] MaskRaster drawSimilar(const SimilarShape& shape, const SolvedSet& set);

/// The parts put together one after the other (add: the larger, subtract: what is left, intersect: the
/// smaller of the two), then softened over `feather` pixels. Throws as the ground does.
[[nodiscard]] MaskRaster drawSelection(const SelectionShape& shape, MaskGround& ground);

}  // namespace swaplight
