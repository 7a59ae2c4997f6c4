#include "core/filter/size_expression.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "core/base/error.h"

namespace swaplight {
namespace {

bool isWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// A recursive descent: sum of products of signed atoms.
class ExpressionReader {
 public:
  ExpressionReader(const std::string& text, const ExpressionVariables& variables)
      : m_text(text), m_variables(variables) {}

  double all() {
    const double value = sum();
    if (peek() != '\0') fail("nothing more");
    return value;
  }

 private:
  static constexpr int kDeepest = 64;
  static constexpr size_t kLongestQuote = 200;

  [[noreturn]] void fail(const std::string& expected) const {
    throw InputError("the expression \"{}{}\": found {} at character {}, expected {}",
                     m_text.substr(0, kLongestQuote), m_text.size() > kLongestQuote ? "..." : "",
                     m_at < m_text.size() ? fmt::format("\"{}\"", m_text.substr(m_at, 12)) : "its end",
                     m_at + 1, expected);
  }
  char peek() {
    while (m_at < m_text.size() && (m_text[m_at] == ' ' || m_text[m_at] == '\t')) ++m_at;
    return m_at < m_text.size() ? m_text[m_at] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++m_at;
    return true;
  }

  double sum() {
    double value = product();
    for (;;) {
      if (take('+'))
        value += product();
      else if (take('-'))
        value -= product();
      else
        return value;
    }
  }
  double product() {
    double value = atom();
    for (;;) {
      if (take('*'))
        value *= atom();
      else if (take('/'))
        value /= atom();
      else if (take('%'))
        value = std::fmod(value, atom());
      else
        return value;
    }
  }
  double atom() {
    if (++m_depth > kDeepest) fail("fewer brackets");
    const double value = signedAtom();
    --m_depth;
    return value;
  }
  double signedAtom() {
    if (take('-')) return -atom();
    if (take('+')) return atom();
    if (take('(')) {
      const double value = sum();
      if (!take(')')) fail("\")\"");
      return value;
    }
    if (take('$')) return variable();
    const char c = peek();
    if ((c >= '0' && c <= '9') || c == '.') return number();
    return function();
  }
  double number() {
    double value = 0;
    const auto [stop, error] = std::from_chars(m_text.data() + m_at, m_text.data() + m_text.size(), value);
    if (error != std::errc()) fail("a number");
    m_at = static_cast<size_t>(stop - m_text.data());
    return value;
  }
  std::string word() {
    const size_t begin = m_at;
    while (m_at < m_text.size() && isWordCharacter(m_text[m_at])) ++m_at;
    return m_text.substr(begin, m_at - begin);
  }
  double variable() {
    const size_t begin = m_at;
    const std::optional<double> value = m_variables(word());
    if (value) return *value;
    m_at = begin;
    fail("$WIDTH, $HEIGHT or the name of an input that is a number");
  }
  double function() {
    const size_t begin = m_at;
    const std::string name = word();
    std::vector<double> arguments;
    if (name.empty() || !take('(')) {
      m_at = begin;
      fail("a number, a $variable, a function or \"(\"");
    }
    do arguments.push_back(sum());
    while (take(','));
    if (!take(')')) fail("\")\"");
    if (const std::optional<double> value = call(name, arguments)) return *value;
    m_at = begin;
    fail("abs, ceil, floor, round, sqrt (of one), min, max or pow (of two)");
  }
  static std::optional<double> call(const std::string& name, const std::vector<double>& a) {
    if (a.size() == 1) {
      if (name == "abs") return std::abs(a[0]);
      if (name == "ceil") return std::ceil(a[0]);
      if (name == "floor") return std::floor(a[0]);
      if (name == "round") return std::round(a[0]);
      if (name == "sqrt") return std::sqrt(a[0]);
    }
    if (a.size() == 2) {
      if (name == "min") return std::min(a[0], a[1]);
      if (name == "max") return std::max(a[0], a[1]);
      if (name == "pow") return std::pow(a[0], a[1]);
    }
    return {};
  }

  const std::string& m_text;
  const ExpressionVariables& m_variables;
  size_t m_at = 0;
  int m_depth = 0;
};

}  // namespace

double expressionValue(const std::string& text, const ExpressionVariables& variables) {
  const double value = ExpressionReader(text, variables).all();
  return std::isfinite(value) ? value : 0;
}

}  // namespace swaplight
