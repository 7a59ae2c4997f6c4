#pragma once

#include <array>
#include <vector>

#include "core/shadow/result/light_shadows.h"

namespace swaplight {

/// A closed line in pixels of the picture (a pixel's centre lies at .5).
using Outline = std::vector<std::array<float, 2>>;

/// The borders of one light's shadows.
struct ShadowOutlines {
  std::vector<Outline> umbra;     ///< around what the light does not reach
  std::vector<Outline> penumbra;  ///< around all that it does not wholly reach
};

/// `labels` are `width` pixels wide; a label pixel covers `scale` pixels of the picture. Lines deviate from
/// the labels by less than `tolerance` label pixels: fewer points are drawn faster.
[[nodiscard]] ShadowOutlines shadowOutlines(const std::vector<ShadowLabel>& labels, int width,
                                            float scale = 1, float tolerance = .6f);

}  // namespace swaplight
