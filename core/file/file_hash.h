#pragma once

#include <filesystem>
#include <string>

namespace swaplight {

/// SHA-256 of a file's bytes as 64 hexadecimal digits, as `sha256sum` prints it; empty where it cannot be
/// read.
[[nodiscard]] std::string sha256OfFile(const std::filesystem::path& file);

}  // namespace swaplight
