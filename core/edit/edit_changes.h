#pragma once

#include <memory>
#include <vector>

#include "core/edit/prepared_edit.h"

namespace swaplight {

/// Where the results of two stacks may differ. Edits that are the same object are the same; an edit that
/// differs from its predecessor by painted strokes only counts where the strokes' masks differ.
[[nodiscard]] PixelRect changedArea(const std::vector<std::shared_ptr<const PreparedEdit>>& before,
                                    const std::vector<std::shared_ptr<const PreparedEdit>>& after);

}  // namespace swaplight
