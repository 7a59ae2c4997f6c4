#pragma once

#include "core/image/image.h"

namespace swaplight {

/// A relief out of normals: depth.Z, widths of the picture, away from the camera, mean 0. The surface whose
/// slopes come closest to those of the normals, dZ/dx = n_x / n_z, as seen at right angles (Frankot and
/// Chellappa 1988; core/shadow/numeric/gradient_integration.h). It is no distance: a step in depth has no
/// normal, so that what stands before something else seems joined to it; refused pixels are taken for flat,
/// and no slope is steeper than 3.
[[nodiscard]] Image reliefOf(const Image& normals);

}  // namespace swaplight
