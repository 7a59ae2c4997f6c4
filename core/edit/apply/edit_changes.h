#pragma once

#include <memory>
#include <set>
#include <vector>

#include "core/edit/apply/prepared_edit.h"

namespace swaplight {

/// Of a set's lights and those that edits add.
using LightIndices = std::set<int>;

[[nodiscard]] LightIndices allLights(int count);

/// Where the results of two stacks may differ: rectangles that may overlap. Edits that are the same object
/// are the same; an edit that differs from its predecessor by painted strokes only counts where the strokes'
/// masks differ.
[[nodiscard]] std::vector<PixelRect> changedAreas(
    const std::vector<std::shared_ptr<const PreparedEdit>>& before,
    const std::vector<std::shared_ptr<const PreparedEdit>>& after);

/// Which of `count` lights the results of two stacks may differ in.
[[nodiscard]] LightIndices changedLights(const std::vector<std::shared_ptr<const PreparedEdit>>& before,
                                         const std::vector<std::shared_ptr<const PreparedEdit>>& after,
                                         int count);

/// The lights, and all whose light active edits take from one and give to another of them: to compute one of
/// them is to compute all.
[[nodiscard]] LightIndices withTiedLights(LightIndices lights,
                                          const std::vector<std::shared_ptr<const PreparedEdit>>& edits,
                                          int count);

/// How many edits at the beginning of two stacks are the same objects.
[[nodiscard]] size_t commonEdits(const std::vector<std::shared_ptr<const PreparedEdit>>& before,
                                 const std::vector<std::shared_ptr<const PreparedEdit>>& after);

}  // namespace swaplight
