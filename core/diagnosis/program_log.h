#pragma once

#include <filesystem>
#include <string_view>

namespace swaplight {

/// Opens the log of what the studio says, for those who look for a fault afterwards: `swaplight.log` in the
/// folder, lines with time and process. One that is found larger than a MiB becomes swaplight.1.log, that
/// one swaplight.2.log; older ones go. A folder that cannot be written is no error.
void openProgramLog(const std::filesystem::path& folder);

/// A line of it, whole even where several programs write. Any thread; does nothing where no log is open, or
/// where it cannot be written.
void logLine(std::string_view words) noexcept;

}  // namespace swaplight
