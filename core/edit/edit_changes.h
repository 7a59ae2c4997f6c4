#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/edit/prepared_edit.h"

namespace swaplight {

/// Where the results of two stacks may differ. Edits that are the same object are the same; an edit that
/// differs from its predecessor by painted strokes only counts where the strokes' masks differ.
[[nodiscard]] PixelRect changedArea(const std::vector<std::shared_ptr<const PreparedEdit>>& before,
                                    const std::vector<std::shared_ptr<const PreparedEdit>>& after);

/// The index of the edit, if all that changed is what is painted in its mask.
[[nodiscard]] std::optional<size_t> paintedEdit(
    const std::vector<std::shared_ptr<const PreparedEdit>>& before,
    const std::vector<std::shared_ptr<const PreparedEdit>>& after);

}  // namespace swaplight
