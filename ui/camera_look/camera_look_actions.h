#pragma once

#include "ui/control/viewer_context.h"
#include "ui/kit/file_chooser.h"

namespace swaplight {

/// A .swaplook file in the place of the document's look. What is wrong with it becomes a message.
void loadCameraLook(ViewerContext& studio, const std::filesystem::path& file);

/// A file that was dropped on the window: a .swaplook is the look from now on, a filter (.fs) is added to it.
/// False where it is neither, or nothing is open that could be seen through it.
bool takeDroppedLook(ViewerContext& studio, const std::filesystem::path& file);

/// Loading, saving and removing the camera look. All that is handed in must outlive the table.
void addCameraLookActions(ActionTable& actions, ViewerContext& studio, FileChooser& chooser);

}  // namespace swaplight
