#pragma once

#include <filesystem>

namespace swaplight {

// Where the program keeps a person's things, after the XDG base directory specification.

/// Settings that a person may edit: $XDG_CONFIG_HOME/swaplight, else ~/.config/swaplight.
[[nodiscard]] std::filesystem::path configFolder();
/// What a person brings in, as gels: $XDG_DATA_HOME/swaplight, else ~/.local/share/swaplight.
[[nodiscard]] std::filesystem::path dataFolder();
/// What the program remembers, as recent files and recovery: $XDG_STATE_HOME/swaplight, else
/// ~/.local/state/swaplight.
[[nodiscard]] std::filesystem::path stateFolder();
/// $HOME, else the root folder.
[[nodiscard]] std::filesystem::path homeFolder();

}  // namespace swaplight
