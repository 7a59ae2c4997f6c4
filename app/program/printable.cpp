#include "app/program/printable.h"

#include <fmt/core.h>

#include <cstdint>

namespace swaplight {
namespace {

struct Character {
  char32_t code = 0;
  size_t bytes = 0;  ///< 0: not UTF-8
};

/// The character that begins a text; overlong forms, surrogates and cut sequences are none.
Character characterAt(std::string_view text) {
  const auto byte = [&](size_t at) { return static_cast<unsigned char>(text[at]); };
  const unsigned first = byte(0);
  if (first < 0x80) return {first, 1};
  const size_t length = first >= 0xf0 && first < 0xf5   ? 4
                        : first >= 0xe0 && first < 0xf0 ? 3
                        : first >= 0xc2 && first < 0xe0 ? 2
                                                        : 0;
  if (length == 0 || length > text.size()) return {};
  char32_t code = first & (0x7fU >> length);
  for (size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3fU);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool noCharacter = (code >= 0xd800 && code < 0xe000) || code > 0x10ffff;
  return overlong || noCharacter ? Character{} : Character{code, length};
}

bool moves(char32_t code) {
  const bool control = code < 0x20 || (code >= 0x7f && code < 0xa0);
  const bool separates = code == 0x2028 || code == 0x2029;
  const bool turns = code == 0x061c || code == 0x200e || code == 0x200f ||
                     (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
  return control || separates || turns;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const Character character = characterAt(text);
    const size_t bytes = character.bytes > 0 ? character.bytes : 1;
    if (character.bytes == 0)
      shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
    else if (moves(character.code) && character.code < 0x100)
      shown += fmt::format("\\x{:02x}", static_cast<uint32_t>(character.code));
    else if (moves(character.code))
      shown += fmt::format("\\u{:04x}", static_cast<uint32_t>(character.code));
    else
      shown += text.substr(0, bytes);
    text.remove_prefix(bytes);
  }
  return shown;
}

}  // namespace swaplight
