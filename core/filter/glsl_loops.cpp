#include "core/filter/glsl_loops.h"

#include <charconv>
#include <string>

namespace swaplight {
namespace {

using Tokens = std::vector<GlslToken>;

/// The tokens of a range that are not blank.
std::vector<std::string> wordsOf(const Tokens& tokens, size_t begin, size_t end) {
  std::vector<std::string> words;
  for (size_t i = begin; i < end; ++i)
    if (tokens[i].kind != GlslToken::Kind::Blank) words.push_back(tokens[i].text);
  return words;
}

bool isNumber(const std::string& word) {
  return !word.empty() && (word[0] == '.' || (word[0] >= '0' && word[0] <= '9'));
}

/// So few turns that they need no counting.
bool isSmallNumber(const std::string& word) {
  constexpr double kFew = 256;
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return isNumber(word) && error == std::errc() && value <= kFew;
}

/// Whether a loop stands between here and there: loops in loops multiply.
bool holdsLoop(const Tokens& tokens, size_t begin, size_t end) {
  for (size_t i = begin; i < end; ++i)
    if (tokens[i].is("for") || tokens[i].is("while")) return true;
  return false;
}

/// "i < 8" or "i <= 8", and "i++", "++i" or "i += 1": it ends, unless the body changes i.
bool plainlyEnds(const std::vector<std::string>& condition, const std::vector<std::string>& step) {
  const bool upTo = (condition.size() == 3 || (condition.size() == 4 && condition[2] == "=")) &&
                    condition[1] == "<" && isSmallNumber(condition.back());
  if (!upTo) return false;
  const std::string& counter = condition[0];
  const auto is = [&](std::initializer_list<std::string> words) { return step == std::vector(words); };
  if (is({counter, "+", "+"}) || is({"+", "+", counter})) return true;
  return step.size() == 4 && step[0] == counter && step[1] == "+" && step[2] == "=" && step[3][0] >= '1' &&
         step[3][0] <= '9';
}

/// Whether something between here and there is assigned to a counter ("i =", "i -=", "i--").
bool assigns(const Tokens& tokens, size_t begin, size_t end, const std::string& counter) {
  for (size_t i = begin; i < end; ++i) {
    if (!tokens[i].is(counter.c_str())) continue;
    const size_t mark = nextToken(tokens, i + 1);
    if (mark >= end || tokens[mark].kind != GlslToken::Kind::Mark) continue;
    const size_t after = nextToken(tokens, mark + 1);
    const std::string two = tokens[mark].text + (after < tokens.size() ? tokens[after].text : "");
    if (two == "--" || two == "-=" || two == "*=" || two == "/=" || (two[0] == '=' && two != "=="))
      return true;
  }
  return false;
}

/// The end of the statement that begins at `at`: its closing brace or semicolon.
size_t endOfStatement(const Tokens& tokens, size_t at) {
  int depth = 0;
  for (size_t i = at; i < tokens.size(); ++i) {
    if (tokens[i].is("{")) ++depth;
    if (tokens[i].is("}") && --depth <= 0) return i;
    if (tokens[i].is(";") && depth == 0) return i;
  }
  return tokens.size();
}

GlslToken mark(const char* text) {
  return {GlslToken::Kind::Mark, text};
}

void guard(Tokens& tokens, size_t begin, size_t end) {
  const bool empty = wordsOf(tokens, begin, end).empty();
  tokens.insert(tokens.begin() + static_cast<ptrdiff_t>(end), mark(empty ? "" : ")"));
  tokens.insert(tokens.begin() + static_cast<ptrdiff_t>(begin), mark(empty ? "isf_go()" : "isf_go() && ("));
}

/// A for loop's two semicolons; false where it has others.
bool semicolonsOf(const Tokens& tokens, size_t open, size_t close, size_t& first, size_t& second) {
  first = second = 0;
  for (size_t i = open; i < close; ++i) {
    if (!tokens[i].is(";")) continue;
    if (second != 0) return false;
    (first == 0 ? first : second) = i;
  }
  return second != 0;
}

}  // namespace

bool boundLoops(Tokens& tokens) {
  bool changed = false;
  for (size_t at = 0; at < tokens.size(); ++at) {
    const bool isFor = tokens[at].is("for");
    if (!isFor && !tokens[at].is("while")) continue;
    const size_t open = nextToken(tokens, at + 1);
    if (open >= tokens.size() || !tokens[open].is("(")) continue;
    const size_t close = closingBracket(tokens, open);
    if (close >= tokens.size()) continue;
    size_t begin = open + 1, end = close;
    if (isFor) {
      size_t first = 0, second = 0;
      if (!semicolonsOf(tokens, open, close, first, second)) continue;
      const std::vector<std::string> condition = wordsOf(tokens, first + 1, second);
      const size_t bodyEnd = endOfStatement(tokens, close + 1);
      if (plainlyEnds(condition, wordsOf(tokens, second + 1, close)) &&
          !holdsLoop(tokens, close + 1, bodyEnd) && !assigns(tokens, close + 1, bodyEnd, condition[0]))
        continue;
      begin = first + 1;
      end = second;
    }
    guard(tokens, begin, end);
    changed = true;
  }
  return changed;
}

}  // namespace swaplight
