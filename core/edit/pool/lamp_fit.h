#pragma once

#include <optional>
#include <span>

#include "core/edit/pool/lamp_model.h"

namespace swaplight {

/// A part of the picture: the mean over some pixels. Places as in lamp_model.h.
struct PoolPixel {
  double x = 0, y = 0;
  double light = 0;   ///< of the light, its channels' mean, linear
  double weight = 0;  ///< 0..1: how surely the light shines there
};

/// Where a lamp has to stand for its light to fall off as it does: n.l / d^2 of the plane, fitted to the
/// logarithm of the light, robustly (Geman and McClure's weights), since what is not the pool is texture and
/// geometry; a prior (a lamp about .8 of the picture's width away, near its middle) holds what the picture
/// does not tell. A lamp with a cone is also as far away as the cone's width (`coneRadius`) makes likely. The
/// aim is the middle of the light, by its weight; the lobe stays that of an even lamp.
[[nodiscard]] LampModel fitLamp(std::span<const PoolPixel> pixels, std::optional<double> coneRadius = {});

}  // namespace swaplight
