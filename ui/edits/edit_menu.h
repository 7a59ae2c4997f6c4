#pragma once

#include "ui/control/editing_context.h"

namespace swaplight {

/// A button with a list of every kind of edit; one that is chosen joins the document's list, for the chosen
/// light.
void drawAddEdit(EditingContext& studio, float width);

/// A beta map from a file for the chosen light, as a new edit once it has been read and is right.
void addPictureEdit(EditingContext& studio, const std::string& file);

/// Another file for such an edit, or its own again: it may have changed.
void setPictureOfEdit(EditingContext& studio, size_t index, const std::string& file);

}  // namespace swaplight
