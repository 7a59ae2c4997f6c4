#pragma once

#include <string>
#include <string_view>

namespace swaplight {

/// A text from a file (a name, a value, a message that quotes them) as it may be shown on a terminal: one
/// line, without anything that moves its cursor, changes its colours or turns the direction of what follows.
/// Control characters (C0, C1, delete), line and paragraph separators, direction overrides (U+200E .. U+2069)
/// and bytes that are not UTF-8 become `\x1b` or `\u202e`.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace swaplight
