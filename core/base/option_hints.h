#pragma once

#include <string>
#include <string_view>

namespace swaplight {

/// A sentence without what it says in brackets of the command line's options, as in "align the photographs
/// (--align on)": for a person who has buttons. Brackets that begin with an option are such; they hold none.
[[nodiscard]] inline std::string withoutOptionHints(std::string_view text) {
  std::string plain(text);
  for (size_t from = 0; (from = plain.find(" (--", from)) != std::string::npos;) {
    const size_t to = plain.find(')', from);
    if (to == std::string::npos) break;
    plain.erase(from, to + 1 - from);
  }
  return plain;
}

}  // namespace swaplight
