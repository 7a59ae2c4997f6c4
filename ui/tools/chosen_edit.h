#pragma once

#include "ui/control/editing_context.h"
#include "ui/control/shadow_edit.h"

namespace swaplight {

/// The edit that is chosen in the list; nullptr: none is.
[[nodiscard]] inline const Edit* chosenEdit(const EditingContext& studio) {
  const auto& edits = studio.document().edits.edits;
  const int chosen = studio.editing.chosen;
  const bool there = chosen >= 0 && chosen < static_cast<int>(edits.size());
  return there ? edits[static_cast<size_t>(chosen)].get() : nullptr;
}

/// The picture shows the handles of the chosen edit: the list of edits is to be seen, the page of shadows is
/// not, which has marks of its own, and no tool is in the hand.
[[nodiscard]] inline bool handlesAreFree(const EditingContext& studio) {
  return !studio.tool && studio.layout.edits && !studio.layout.hidden && !shadowsShown(studio);
}

}  // namespace swaplight
