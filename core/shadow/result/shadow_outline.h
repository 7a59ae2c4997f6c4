#pragma once

#include <array>
#include <vector>

#include "core/shadow/result/light_shadows.h"

namespace swaplight {

/// A closed line in pixels of the picture (a pixel's centre lies at .5). What it encloses, the shadow, lies
/// to the left of who walks along it and sees the picture as on a screen; also along the border of a hole.
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

/// Short lines on the shadow's side of an outline, upright on it: which side is shadow. `spacing` and
/// `length` in pixels of the picture. Outlines shorter than two spacings have none.
struct OutlineTick {
  std::array<float, 2> from, to;
};
[[nodiscard]] std::vector<OutlineTick> shadowTicks(const Outline& outline, float spacing, float length);

}  // namespace swaplight
