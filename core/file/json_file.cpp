#include "core/file/json_file.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/atomic_file.h"

namespace swaplight {
namespace {

constexpr size_t kLargestFile = size_t{64} << 20;
constexpr size_t kDeepest = 100;    // nothing of ours nests deeper; bounds the recursion of those who walk it
constexpr size_t kMostKeys = 4096;  // of one object: they are searched one after the other
constexpr size_t kMostValues = 8 << 20;  // of a file: two million points of strokes, a gigabyte of memory

/// Counts what a text holds before it is parsed, so that a small file cannot take minutes or all memory. (Not
/// while it is parsed: the library's parser with a callback looks through the list around it after each
/// object.)
class Budget : public nlohmann::json_sax<Json> {
 public:
  explicit Budget(const std::string& name) : m_name(name) {}

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(string_t&) override { return value(); }
  bool binary(binary_t&) override { return value(); }
  bool start_object(size_t) override { return enter(); }
  bool start_array(size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }
  bool key(string_t& name) override {
    std::set<std::string>& keys = m_keys.back();
    if (keys.size() == kMostKeys)
      throw InputError("{}: has an object of more than {} keys, which this kind of file never has.", m_name,
                       kMostKeys);
    // JSON leaves open which one counts.
    if (!keys.insert(name).second)
      throw InputError("{}: has \"{}\" twice in one object. Leave one of them out.", m_name, name);
    return true;
  }
  /// The parser says it better.
  bool parse_error(size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

 private:
  bool value() {
    if (++m_values > kMostValues)
      throw InputError("{}: holds more than {} values, which this kind of file never does.", m_name,
                       kMostValues);
    return true;
  }
  bool enter() {
    m_keys.emplace_back();
    if (m_keys.size() > kDeepest + 1)
      throw InputError("{}: is nested deeper than {} levels.", m_name, kDeepest);
    return value();
  }
  bool leave() {
    m_keys.pop_back();
    return true;
  }

  const std::string& m_name;
  std::vector<std::set<std::string>> m_keys;  ///< of each object that is open
  size_t m_values = 0;
};

/// "line 3, column 17" of a byte of the text.
std::string lineAndColumn(std::string_view text, size_t byte) {
  const std::string_view before = text.substr(0, byte);
  const size_t lineStart = before.rfind('\n') + 1;  // npos + 1 is 0
  return fmt::format("line {}, column {}", 1 + std::count(before.begin(), before.end(), '\n'),
                     1 + before.size() - lineStart);
}

/// Where, the parser's own words, and what people usually got wrong.
std::string syntaxError(std::string_view text, const Json::parse_error& error) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  const size_t begin = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  if (const size_t first = text.find_first_not_of(" \t\r\n", begin);
      first == std::string_view::npos || (text[first] != '{' && text[first] != '['))
    return "line 1, column 1: no JSON, which begins with { or [: is it another file?";
  const std::string_view all = error.what();
  const size_t cause = std::min(all.find("syntax error"), all.size());
  const std::string_view words = all.substr(cause, all.find("; last read") - cause);
  const size_t byte = std::min(text.size(), error.byte > 0 ? error.byte - 1 : 0);
  const std::string_view rest = text.substr(byte);
  const bool number = rest.starts_with("NaN") || rest.starts_with("Inf");
  return fmt::format("{}: {}{}", lineAndColumn(text, byte), words,
                     number ? " (JSON knows no NaN and no Infinity: give finite numbers)" : "");
}

}  // namespace

Json parseJson(const std::string& text, const std::string& name) {
  try {
    Budget budget(name);
    static_cast<void>(Json::sax_parse(text, &budget));
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw InputError("{}: {}", name, syntaxError(text, error));
  } catch (const Json::out_of_range& error) {
    // The message quotes the number but does not say where it stands.
    const std::string words = error.what();
    const size_t from = words.find('\'') + 1;
    const std::string number = words.substr(from, words.rfind('\'') - from);
    throw InputError("{}: {}: the number {} is too large.", name, lineAndColumn(text, text.find(number)),
                     number.size() <= 40 ? number : number.substr(0, 40) + "...");
  }
}

Json readJson(const std::filesystem::path& file) {
  return parseJson(readFile(file, kLargestFile), file.string());
}

void writeJson(const Json& json, const std::filesystem::path& file) {
  writeFile(file, jsonText(json, 1) + "\n");
}

std::string jsonText(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

Json jsonNumber(float value) {
  if (!std::isfinite(value)) return nullptr;
  return std::stod(fmt::format("{}", value));
}

}  // namespace swaplight
