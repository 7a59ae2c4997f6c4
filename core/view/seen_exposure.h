#pragma once

#include <optional>
#include <span>

#include "core/view/view_layer.h"

namespace swaplight {

/// How many stops brighter the sum of layers has to be shown so that its brightest hundredth comes to .7 of
/// linear light, which leaves half a stop for highlights; negative where it is brighter. Nothing where no
/// light is seen. The layers are of one size; read at a small one.
[[nodiscard]] std::optional<float> stopsToSee(std::span<const ViewLayer> layers);

}  // namespace swaplight
