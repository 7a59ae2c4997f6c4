#pragma once

#include <span>
#include <vector>

#include "render/filter/filter_program.h"

namespace swaplight {

/// A filter that is drawn part by part.
struct PlannedStage {
  const FilterProgram* program;
  std::span<const FilterValue> values;
  int halo = 0;  ///< see FilterProgram::halo
};

/// Filters begin .. end - 1, which are drawn one after the other on each part of the frame.
struct PartGroup {
  size_t begin = 0, end = 0;
  int halo = 0;  ///< of all of them together, in pixels
  int side = 0;  ///< of the largest part, in pixels
};

/// What a part may take.
struct PartLimits {
  int side = 0;             ///< of a part, in pixels
  int textureSide = 0;      ///< of a part and its halo, in pixels: what the graphics driver takes
  size_t textureBytes = 0;  ///< all textures that are held while it is drawn
};

/// How a run of filters is drawn on a frame. The halo of a part is the sum of its filters', and a filter is
/// drawn on the halos of those after it, too. A frame that is one part has none. On a larger one filters that
/// look far are drawn by themselves, with those that look at their own pixel alone: for more of them at a
/// time the halos would soon be many times the part.
///
/// Parts become smaller until they keep to the limits, but for `textureBytes` no narrower than 3/4 of their
/// halo: pixels would be drawn over and over, and take nearly as many bytes. Where not even the smallest
/// parts keep to `textureSide`, largestInput() shows it.
[[nodiscard]] std::vector<PartGroup> planParts(std::span<const PlannedStage> stages, int width, int height,
                                               const PartLimits& limits);

/// What the largest of a group's parts is drawn from.
[[nodiscard]] FilterWindow largestInput(const PartGroup& group, int width, int height);

}  // namespace swaplight
