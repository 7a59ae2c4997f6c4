#pragma once

#include <filesystem>
#include <string>

namespace swaplight {

/// What is wrong with the header of an OpenEXR file: an attribute that says that it is longer than the file
/// (readers allocate that before they look), or has another size than its type (readers get out of step), a
/// window of pixels that has none or is longer than 2^17, a header without an end. Empty where nothing is.
/// Reads names, types and sizes, and values whose length is in them (OpenEXR File Layout: name, type, size,
/// value).
[[nodiscard]] std::string exrHeaderFault(const std::filesystem::path& file);

}  // namespace swaplight
