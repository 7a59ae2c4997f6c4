#pragma once

#include <opencv2/core.hpp>

#include "core/edit/mask/mask.h"
#include "core/shadow/result/light_shadows.h"

namespace swaplight {

/// A part of a picture of width x height as a mask: float pixels, the first of them at `corner`, which may
/// lie outside.
[[nodiscard]] MaskRaster rasterOf(const cv::Mat& pixels, cv::Point corner, int width, int height);

// Shapes that are drawn once, as pixels.

[[nodiscard]] MaskRaster drawShape(const PolygonShape& shape, int width, int height);
[[nodiscard]] MaskRaster drawShape(const TextShape& shape, int width, int height);
/// Throws InputError where the file cannot be read.
[[nodiscard]] MaskRaster drawShape(const PictureShape& shape, int width, int height);
/// Throws InputError where `region` is asked for and the pixel lies in no shadow.
[[nodiscard]] MaskRaster drawShape(const ShadowShape& shape, const LightShadows& shadows);
/// The whole of one shadow (`shape.region`) and what is nearer to it than to another, up to `zone` pixels
/// away. For changes that are themselves measured by the visibility. Throws as above.
[[nodiscard]] MaskRaster drawShadowZone(const ShadowShape& shape, const LightShadows& shadows, int zone);

}  // namespace swaplight
