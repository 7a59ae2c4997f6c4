#pragma once

#include "ui/control/viewer_context.h"

namespace swaplight {

/// The filters of the document's camera look, the first one on top: on or off, dragged to another place,
/// chosen. Filters of the library are dropped on it.
void drawFilterList(ViewerContext& studio);

/// A filter of the library behind all others, in focus; or at a place.
void addToLook(ViewerContext& studio, const std::string& filter, std::optional<size_t> at = {});

/// A filter of the look goes into the person's library, with its parameters as its defaults.
void keepStage(ViewerContext& studio, size_t index);

/// What is dragged from the list: a filter's index.
inline constexpr const char* kDraggedStage = "swaplight stage";

}  // namespace swaplight
