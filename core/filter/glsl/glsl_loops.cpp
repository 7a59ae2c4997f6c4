#include "core/filter/glsl/glsl_loops.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <string>

namespace swaplight {
namespace {

using Tokens = std::vector<GlslToken>;

// A filter may hold as many loops as fit into its file, inside of each other or without an end: all of this
// costs what the text is long.

constexpr size_t kMostWords = 4;  // of the condition and the step of a loop that plainly ends

/// The tokens of a range that are not blank; no more than can be of interest.
std::vector<std::string> wordsOf(const Tokens& tokens, size_t begin, size_t end) {
  std::vector<std::string> words;
  for (size_t i = begin; i < end && words.size() <= kMostWords; ++i)
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

/// Whether the word at `at` is changed other than forwards ("i =", "i -=", "i--").
bool isAssigned(const Tokens& tokens, size_t at) {
  const size_t mark = nextToken(tokens, at + 1);
  if (mark >= tokens.size() || tokens[mark].kind != GlslToken::Kind::Mark) return false;
  const size_t after = nextToken(tokens, mark + 1);
  const std::string two = tokens[mark].text + (after < tokens.size() ? tokens[after].text : "");
  return two == "--" || two == "-=" || two == "*=" || two == "/=" || (two[0] == '=' && two != "==");
}

bool isLoop(const GlslToken& token) {
  return token.is("for") || token.is("while");
}

/// Whether the statement that begins at `at`, to its closing brace or semicolon, leaves the counter alone and
/// holds no loop: loops in loops multiply.
bool isPlainBody(const Tokens& tokens, size_t at, const std::string& counter) {
  int depth = 0;
  for (size_t i = at; i < tokens.size(); ++i) {
    if (isLoop(tokens[i]) || (tokens[i].is(counter.c_str()) && isAssigned(tokens, i))) return false;
    if (tokens[i].is("{")) ++depth;
    if ((tokens[i].is("}") && --depth <= 0) || (tokens[i].is(";") && depth == 0)) return true;
  }
  return true;
}

/// What lies between brackets.
struct Brackets {
  size_t close = 0;  ///< 0: never closed
  std::array<size_t, 2> semicolons = {};
  size_t semicolonCount = 0;
};

/// Every opening bracket's, by its place.
std::map<size_t, Brackets> bracketsOf(const Tokens& tokens) {
  std::map<size_t, Brackets> all;
  std::vector<std::map<size_t, Brackets>::iterator> open;
  for (size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].is("(") || tokens[i].is("[")) open.push_back(all.emplace_hint(all.end(), i, Brackets{}));
    if (open.empty()) continue;
    Brackets& inner = open.back()->second;
    if (tokens[i].is(";") && inner.semicolonCount++ < 2) inner.semicolons[inner.semicolonCount - 1] = i;
    if (!tokens[i].is(")") && !tokens[i].is("]")) continue;
    inner.close = i;
    open.pop_back();
  }
  return all;
}

/// Tokens that are put in before others, which keep their places until all of them are known.
class Insertions {
 public:
  /// The condition between here and there asks isf_go(), too.
  void guard(const Tokens& tokens, size_t begin, size_t end) {
    const bool empty = wordsOf(tokens, begin, end).empty();
    m_marks.emplace(begin, empty ? "isf_go()" : "isf_go() && (");
    if (!empty) m_marks.emplace(end, ")");
  }
  [[nodiscard]] bool empty() const { return m_marks.empty(); }
  [[nodiscard]] Tokens applied(Tokens tokens) const {
    Tokens all;
    all.reserve(tokens.size() + m_marks.size());
    auto mark = m_marks.begin();
    for (size_t i = 0; i < tokens.size(); ++i) {
      for (; mark != m_marks.end() && mark->first == i; ++mark)
        all.push_back({GlslToken::Kind::Mark, mark->second});
      all.push_back(std::move(tokens[i]));
    }
    return all;
  }

 private:
  std::multimap<size_t, const char*> m_marks;
};

/// A for loop's condition, its step and its body say that it ends.
bool plainlyEnds(const Tokens& tokens, const Brackets& head) {
  const std::vector<std::string> condition = wordsOf(tokens, head.semicolons[0] + 1, head.semicolons[1]);
  return plainlyEnds(condition, wordsOf(tokens, head.semicolons[1] + 1, head.close)) &&
         isPlainBody(tokens, head.close + 1, condition[0]);
}

}  // namespace

bool boundLoops(Tokens& tokens) {
  const std::map<size_t, Brackets> brackets = bracketsOf(tokens);
  Insertions guards;
  for (size_t at = 0; at < tokens.size(); ++at) {
    if (!isLoop(tokens[at])) continue;
    const size_t open = nextToken(tokens, at + 1);
    if (open >= tokens.size() || !tokens[open].is("(")) continue;
    const Brackets& head = brackets.at(open);
    if (head.close == 0) continue;
    if (tokens[at].is("while"))
      guards.guard(tokens, open + 1, head.close);
    else if (head.semicolonCount == 2 && !plainlyEnds(tokens, head))
      guards.guard(tokens, head.semicolons[0] + 1, head.semicolons[1]);
  }
  if (guards.empty()) return false;
  tokens = guards.applied(std::move(tokens));
  return true;
}

}  // namespace swaplight
