#pragma once

#include <memory>
#include <vector>

#include "core/edit/apply/prepared_edit.h"

namespace swaplight {

/// Where the results of two stacks may differ: rectangles that may overlap. Edits that are the same object
/// are the same; an edit that differs from its predecessor by painted strokes only counts where the strokes'
/// masks differ.
[[nodiscard]] std::vector<PixelRect> changedAreas(
    const std::vector<std::shared_ptr<const PreparedEdit>>& before,
    const std::vector<std::shared_ptr<const PreparedEdit>>& after);

/// How many edits at the beginning of two stacks are the same objects.
[[nodiscard]] size_t commonEdits(const std::vector<std::shared_ptr<const PreparedEdit>>& before,
                                 const std::vector<std::shared_ptr<const PreparedEdit>>& after);

}  // namespace swaplight
