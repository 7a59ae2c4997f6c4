#pragma once

#include <filesystem>

#include "core/ocio/display_choice.h"

namespace swaplight {

// The display, view and look that sets open in: those that were chosen last in a colour configuration, the
// same for every set. A session opens in its own.

/// Where they are kept. Below, no file: nothing is remembered.
[[nodiscard]] std::filesystem::path viewMemoryFile(const std::filesystem::path& stateFolder);
/// What was chosen last in this configuration, if it still has it. Else the built-in one's view with a
/// rolled-off shoulder, and another configuration's own: whoever made it knows what its pictures are for.
[[nodiscard]] DisplayChoice openingView(const ColorConfig& config, const std::filesystem::path& file);
/// Keeps a choice, without its grade, which is the session's. One that cannot be written is no reason to stop
/// anybody.
void rememberView(const ColorConfig& config, const DisplayChoice& choice, const std::filesystem::path& file);

}  // namespace swaplight
