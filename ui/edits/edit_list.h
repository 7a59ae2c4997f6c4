#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// The edits of the document, the last on top: on or off, name, order, opacity.
void drawEditList(EditingContext& studio);

/// Begins to type another name for an edit of the list.
void renameEdit(EditingContext& studio, size_t index);
void deleteEdit(EditingContext& studio, size_t index);

/// Changes the list as one step.
void editEdits(EditingContext& studio, const std::string& step, EditStack edits);
/// Changes an edit of the list as one step.
void editEdit(EditingContext& studio, size_t index, const std::string& step, Edit edit);
/// Shows an edit changed while a gesture goes on.
void previewEdit(EditingContext& studio, size_t index, const std::string& step, Edit edit);

}  // namespace swaplight
