#pragma once

#include "ui/control/editing_context.h"
#include "ui/kit/file_chooser.h"

namespace swaplight {

// What can be done with edits and the tools that make them. Everything that is handed in must outlive the
// table.

void addBrushActions(ActionTable& actions, EditingContext& studio);
/// Selections and stencils.
void addSelectionActions(ActionTable& actions, EditingContext& studio, FileChooser& chooser);
/// The list of the edits.
void addEditActions(ActionTable& actions, EditingContext& studio, FileChooser& chooser);

}  // namespace swaplight
