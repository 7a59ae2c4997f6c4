#pragma once

#include "core/edit/mask/mask.h"

namespace swaplight {

// What is selected, as the mask that restricts edits: nothing in it means that nothing is selected and edits
// reach everywhere; else one SelectionShape.

/// How a new part meets what is selected.
enum class SelectHow { Replace, Add, Subtract, Intersect };

/// The selection with another part. Nothing is left of nothing: subtracting from an empty selection gives an
/// empty one.
[[nodiscard]] Mask selectionWith(const Mask& selection, MaskShape part, SelectHow how);
/// What was not selected; an empty selection stays empty.
[[nodiscard]] Mask invertedSelection(const Mask& selection);
/// With an edge that falls from 1 to 0 over this many pixels.
[[nodiscard]] Mask featheredSelection(const Mask& selection, float feather);
/// 0 where nothing is selected.
[[nodiscard]] float featherOf(const Mask& selection);

/// The part of an edit's mask that a selection has restricted it to.
[[nodiscard]] Mask selectionOf(const Mask& mask);
/// The mask restricted to this selection instead of the one that it has.
[[nodiscard]] Mask maskWithin(const Mask& mask, const Mask& selection);

}  // namespace swaplight
