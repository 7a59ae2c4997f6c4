#pragma once

#include "core/session/document_editor.h"

namespace swaplight {

/// Every step that was taken; a click goes there.
void drawHistoryPanel(DocumentEditor& editor, bool* open);

}  // namespace swaplight
