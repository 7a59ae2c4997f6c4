#pragma once

#include <string>

#include "ui/control/editing_context.h"

namespace swaplight {

/// Adds a light that the edits make to a document, with `word` or word2, word3 ... as its name, and chooses
/// it. Returns the name.
std::string addNewLight(EditingContext& studio, const std::string& word, Document& document);

}  // namespace swaplight
