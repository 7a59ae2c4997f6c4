#pragma once

#include "core/session/document_editor.h"
#include "ui/camera/look_shelf.h"
#include "ui/jobs/messages.h"

namespace swaplight {

/// What those need who offer camera looks to be chosen.
struct LookChoice {
  DocumentEditor& editor;
  LookShelf& shelf;
  Messages& messages;
};

/// Lines of a menu: every camera look of the library, to be chosen by a click, with a star that makes it a
/// favourite. True where one was chosen.
bool drawLookLines(const LookChoice& studio);

}  // namespace swaplight
