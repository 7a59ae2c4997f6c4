#include "core/file/json_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/atomic_file.h"

namespace swaplight {
namespace {

constexpr size_t kLargestFile = size_t{64} << 20;
constexpr int kDeepest = 100;       // nothing of ours nests deeper; bounds the recursion of those who walk it
constexpr size_t kMostKeys = 4096;  // of one object: they are searched one after the other
constexpr size_t kMostValues = 8 << 20;  // of a file: two million points of strokes, a gigabyte of memory

/// Counts while a text is parsed, so that a small file cannot take minutes or all memory.
class ParseBudget {
 public:
  explicit ParseBudget(const std::string& name) : m_name(name) {}

  bool allow(int depth, Json::parse_event_t event) {
    using Event = Json::parse_event_t;
    if (depth > kDeepest) throw InputError("{}: is nested deeper than {} levels.", m_name, kDeepest);
    if (event == Event::object_start) m_keys[static_cast<size_t>(depth)] = 0;
    // The key of an object that began at depth d is told at depth d + 1.
    if (event == Event::key && depth > 0 && ++m_keys[static_cast<size_t>(depth - 1)] > kMostKeys)
      throw InputError("{}: has an object of more than {} keys, which this kind of file never has.", m_name,
                       kMostKeys);
    if (event != Event::key && ++m_values > kMostValues)
      throw InputError("{}: holds more than {} values, which this kind of file never does.", m_name,
                       kMostValues);
    return true;
  }

 private:
  const std::string& m_name;
  std::array<size_t, kDeepest + 2> m_keys{};
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
    ParseBudget budget(name);
    return Json::parse(
        text, [&](int depth, Json::parse_event_t event, const Json&) { return budget.allow(depth, event); });
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
