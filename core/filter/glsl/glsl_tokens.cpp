#include "core/filter/glsl/glsl_tokens.h"

#include <cctype>

namespace swaplight {
namespace {

bool isWordStart(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}

bool isWordPart(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

bool isSpace(char c) {
  return std::isspace(static_cast<unsigned char>(c)) || c == '\0';
}

/// Where the piece that begins at `at` ends.
size_t endOfToken(const std::string& s, size_t at, GlslToken::Kind& kind) {
  const auto runOf = [&](auto&& belongs) {
    size_t end = at + 1;
    while (end < s.size() && belongs(s[end])) ++end;
    return end;
  };
  kind = GlslToken::Kind::Blank;
  if (s.compare(at, 2, "//") == 0) return std::min(s.find('\n', at), s.size());
  if (s.compare(at, 2, "/*") == 0) {
    const size_t close = s.find("*/", at + 2);
    return close == std::string::npos ? s.size() : close + 2;
  }
  if (isSpace(s[at])) return runOf(isSpace);
  if (isWordStart(s[at])) {
    kind = GlslToken::Kind::Word;
    return runOf(isWordPart);
  }
  const bool fraction =
      s[at] == '.' && at + 1 < s.size() && std::isdigit(static_cast<unsigned char>(s[at + 1]));
  if (std::isdigit(static_cast<unsigned char>(s[at])) || fraction) {
    kind = GlslToken::Kind::Number;
    return runOf([](char c) { return isWordPart(c) || c == '.'; });
  }
  kind = GlslToken::Kind::Mark;
  return at + 1;
}

}  // namespace

std::vector<GlslToken> glslTokens(const std::string& source) {
  std::vector<GlslToken> tokens;
  for (size_t at = 0; at < source.size();) {
    GlslToken token;
    const size_t end = endOfToken(source, at, token.kind);
    token.text = source.substr(at, end - at);
    tokens.push_back(std::move(token));
    at = end;
  }
  return tokens;
}

std::string glslText(const std::vector<GlslToken>& tokens) {
  std::string text;
  for (const GlslToken& token : tokens) text += token.text;
  return text;
}

size_t nextToken(const std::vector<GlslToken>& tokens, size_t at) {
  while (at < tokens.size() && tokens[at].kind == GlslToken::Kind::Blank) ++at;
  return at;
}

}  // namespace swaplight
