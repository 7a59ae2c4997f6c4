#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// The edit that is chosen in the list; nullptr: none is.
[[nodiscard]] inline const Edit* chosenEdit(const EditingContext& studio) {
  const auto& edits = studio.document().edits.edits;
  const int chosen = studio.editing.chosen;
  const bool there = chosen >= 0 && chosen < static_cast<int>(edits.size());
  return there ? edits[static_cast<size_t>(chosen)].get() : nullptr;
}

}  // namespace swaplight
