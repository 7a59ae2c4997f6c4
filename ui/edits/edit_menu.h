#pragma once

#include "ui/control/studio_context.h"

namespace swaplight {

/// A button with a list of every kind of edit; one that is chosen joins the document's list, for the chosen
/// light.
void drawAddEdit(StudioContext& studio, float width);

/// A beta map from a file for the chosen light, as a new edit once it has been read and is right.
void addPictureEdit(StudioContext& studio, const std::string& file);

/// Another file for such an edit, or its own again: it may have changed.
void setPictureOfEdit(StudioContext& studio, size_t index, const std::string& file);

}  // namespace swaplight
