#pragma once

#include <filesystem>
#include <string>

#include "core/filter/filter.h"

namespace swaplight {

/// Bytes of a filter's file; what is larger is refused.
inline constexpr size_t kLargestFilter = 4 << 20;

/// Reads a filter: an ISF 1 or 2 file (.fs), with the vertex shader (.vs) beside it where there is one.
/// Throws InputError, one line that names the file and, in its header, the line: no header, a broken one, an
/// input without a name, a type that ISF lacks, an expression that cannot be read ...
[[nodiscard]] Filter readFilter(const std::filesystem::path& file);

/// The same from text; `file` names it in messages and is where imported pictures are looked for.
[[nodiscard]] Filter filterFromText(const std::string& text, const std::filesystem::path& file);

}  // namespace swaplight
