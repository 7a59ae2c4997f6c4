#pragma once

#include <filesystem>

namespace swaplight {

/// How the window stood last, and where files were last chosen: the person's own, the same for every session.
struct WindowMemory {
  int width = 1600, height = 900;  ///< as it is when not maximised, in units of the desktop
  bool maximized = false;
  std::filesystem::path folder;  ///< empty: none yet
  bool operator==(const WindowMemory&) const = default;
};

/// Where it is kept.
[[nodiscard]] std::filesystem::path windowMemoryFile();
/// Defaults where there is no file, or none that can be read; sizes that no window has are the defaults.
[[nodiscard]] WindowMemory readWindowMemory(const std::filesystem::path& file);
/// One that cannot be written is no reason to stop anybody.
void writeWindowMemory(const WindowMemory& memory, const std::filesystem::path& file);

}  // namespace swaplight
