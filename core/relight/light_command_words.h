#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/relight/rig.h"

namespace swaplight {

/// A word of a desk's line: see light_command.h.
struct LightWord {
  std::string text;  ///< without quotes
  size_t begin = 0;  ///< its place in the line
  bool quoted = false;
};

/// @ is a word of its own; 1+3 and 1, 3 are 1 + 3, 1-3 is 1 thru 3; other commas part words. Throws
/// InputError where a quote does not end.
[[nodiscard]] std::vector<LightWord> lightWords(std::string_view line);

/// Reads words one after the other.
class LightWordReader {
 public:
  explicit LightWordReader(std::vector<LightWord> words) : m_words(std::move(words)) {}
  [[nodiscard]] bool atEnd() const { return m_next == m_words.size(); }
  [[nodiscard]] const LightWord& peek() const { return m_words[m_next]; }
  LightWord take() { return m_words[m_next++]; }
  /// Takes the next word where it is one of these, in any case.
  bool takeIf(std::initializer_list<std::string_view> any);

 private:
  std::vector<LightWord> m_words;
  size_t m_next = 0;
};

/// The lights that a word means: by number from 1, name, label, group, role, or "all"; nothing where it means
/// none. Throws InputError for a number that no light has.
[[nodiscard]] std::optional<std::vector<size_t>> lightsOfWord(const Rig& rig, const LightWord& word);

/// Takes the words that name lights, with + - thru, from the beginning; without any: nothing. In the rig's
/// order.
[[nodiscard]] std::optional<std::vector<size_t>> takeLights(const Rig& rig, LightWordReader& words);

/// "1 key, 2 fill, 3 back".
[[nodiscard]] std::string numberedLights(const Rig& rig);

[[nodiscard]] bool sameWord(std::string_view a, std::string_view b);

}  // namespace swaplight
