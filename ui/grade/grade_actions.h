#pragma once

#include <filesystem>

#include "ui/control/viewer_context.h"
#include "ui/kit/file_chooser.h"

namespace swaplight {

/// Loading, saving, switching and resetting the grade.
void addGradeActions(ActionTable& actions, ViewerContext& studio, FileChooser& chooser);
/// A .cc, .ccc or .cdl dropped on the window becomes the grade. False for any other file, and without a set.
bool takeDroppedGrade(ViewerContext& studio, const std::filesystem::path& file);

}  // namespace swaplight
