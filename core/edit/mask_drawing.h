#pragma once

#include "core/edit/mask.h"
#include "core/shadow/light_shadows.h"

namespace swaplight {

// Shapes that are drawn once, as pixels.

[[nodiscard]] MaskRaster drawShape(const PolygonShape& shape, int width, int height);
[[nodiscard]] MaskRaster drawShape(const TextShape& shape, int width, int height);
/// Throws InputError where the file cannot be read.
[[nodiscard]] MaskRaster drawShape(const PictureShape& shape, int width, int height);
/// Throws InputError where `region` is asked for and the pixel lies in no shadow.
[[nodiscard]] MaskRaster drawShape(const ShadowShape& shape, const LightShadows& shadows);

}  // namespace swaplight
