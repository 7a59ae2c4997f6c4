#pragma once

#include <filesystem>

#include "core/base/lower_case.h"

namespace swaplight {

inline constexpr const char* kFilterEnding = ".fs";
inline constexpr const char* kLookEnding = ".swaplook";

/// Whether a name is that of a filter's file, not of a filter: in capitals, too.
[[nodiscard]] inline bool isFilterFile(const std::filesystem::path& name) {
  return lowerExtension(name) == kFilterEnding;
}

/// The same of a look's file.
[[nodiscard]] inline bool isLookFile(const std::filesystem::path& name) {
  return lowerExtension(name) == kLookEnding;
}

}  // namespace swaplight
