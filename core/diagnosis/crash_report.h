#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace swaplight {

/// From here on a crash of this process (a signal, an exception that nobody catches) writes a report into the
/// folder (what, where in the program, the facts below), removes temporary files, says on the descriptor
/// `words` where the report is, and then ends as it would have. Call it once. Under the sanitizers, which
/// report themselves, and where the folder cannot be written, it does nothing.
void reportCrashes(const std::filesystem::path& folder, int words);

/// A line of the report, from here on: "graphics", "llvmpipe". The same name again replaces it. Any thread.
void setCrashFact(std::string_view name, std::string_view value);

/// The newest report in the folder that this has not given before.
[[nodiscard]] std::optional<std::filesystem::path> unseenCrash(const std::filesystem::path& folder);

}  // namespace swaplight
