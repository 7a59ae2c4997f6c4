#pragma once

#include <imgui.h>

#include <optional>

#include "core/shadow/detect/shadow_preview.h"

namespace swaplight {

/// How bright a light shows over the picture, as a plot of which the threshold can be dragged (ShadowOptions:
/// the shading over that of lit pixels). Returns the threshold in the frames in which it is moved.
[[nodiscard]] std::optional<float> shadowHistogram(const ShadowHistogram& histogram, float threshold,
                                                   ImVec2 size);

}  // namespace swaplight
