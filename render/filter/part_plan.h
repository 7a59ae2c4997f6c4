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
  int side = 0;  ///< of the largest part, in pixels
};

/// How a run of filters is drawn on a frame. The halo of a part is the sum of its filters', and a filter is
/// drawn on the halos of those after it, too. A frame that is one part has none. On a larger one filters that
/// look far are drawn by themselves, with those that look at their own pixel alone: for more of them at a
/// time the halos would soon be many times the part. What a part takes in textures stays below `mostBytes`.
[[nodiscard]] std::vector<PartGroup> planParts(std::span<const PlannedStage> stages, int width, int height,
                                               int mostSide, size_t mostBytes);

}  // namespace swaplight
