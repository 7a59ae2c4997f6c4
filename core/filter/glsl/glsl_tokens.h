#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace swaplight {

/// A piece of GLSL. All of a text's pieces together are the text, so that lines keep their numbers.
struct GlslToken {
  enum class Kind { Word, Number, Mark, Blank };  ///< Blank: spaces, line ends and comments
  Kind kind = Kind::Blank;
  std::string text;

  [[nodiscard]] bool is(const char* what) const { return text == what; }
};

[[nodiscard]] std::vector<GlslToken> glslTokens(const std::string& source);
[[nodiscard]] std::string glslText(const std::vector<GlslToken>& tokens);

/// The next token at or behind `at` that is not blank; the number of tokens where there is none.
[[nodiscard]] size_t nextToken(const std::vector<GlslToken>& tokens, size_t at);

}  // namespace swaplight
