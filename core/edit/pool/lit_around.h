#pragma once

#include <memory>

#include "core/image/image.h"

namespace swaplight {

/// Where shadows lie among lit surfaces: one channel, 1 where lit surfaces are seen in three of four
/// directions from a pixel, 0 where in half of them or less. What is dark beyond all that is lit (the rest of
/// the room beside a window's light) sees them on one side only, and whether the lamp would reach it without
/// what casts shadows no photograph says. Beyond the picture is more of what most of its border is.
/// `visibility`: one channel, 0..1; lit is above .5.
[[nodiscard]] std::shared_ptr<const Image> litAround(const Image& visibility);

}  // namespace swaplight
