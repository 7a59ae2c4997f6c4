#pragma once

#include "ui/studio_context.h"

namespace swaplight {

/// A button with a list of every kind of edit; one that is chosen joins the document's list, for the chosen
/// light.
void drawAddEdit(StudioContext& studio, float width);

/// A beta map from a file (as `swaplight beta` writes it) for the chosen light, as a new edit.
void addPictureEdit(StudioContext& studio, const std::string& file);

/// Another file for such an edit.
void setPictureOfEdit(StudioContext& studio, size_t index, const std::string& file);

}  // namespace swaplight
