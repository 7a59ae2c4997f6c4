#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace swaplight {

/// Unsaved work of studios that died and that cannot be read (a byte is wrong, a newer program wrote it, no
/// permission) is never deleted: each is renamed to ID.broken, for somebody to mend. Gives a line for each:
/// why, and where it is. To be called after findRecovered, which leaves them alone.
[[nodiscard]] std::vector<std::string> setBrokenAside(const std::filesystem::path& folder);

/// The same for one that turned out to be broken.
[[nodiscard]] std::string setAside(const std::filesystem::path& session, const std::string& reason);

}  // namespace swaplight
