#pragma once

#include <filesystem>
#include <string>

namespace swaplight {

/// What is wrong with the header of an OpenEXR file: an attribute that says that it is longer than the file
/// (readers allocate that before they look), a header without an end. Empty where nothing is. Reads the
/// attributes' names and sizes only (OpenEXR File Layout: name, type, size, value).
[[nodiscard]] std::string exrHeaderFault(const std::filesystem::path& file);

}  // namespace swaplight
