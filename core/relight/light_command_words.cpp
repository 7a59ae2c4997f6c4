#include "core/relight/light_command_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "core/base/error.h"
#include "core/base/lower_case.h"

namespace swaplight {
namespace {

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool isDigits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), isDigit);
}

bool partsWords(char c) {
  return std::isspace(static_cast<unsigned char>(c)) || c == ',';
}

LightWord quotedWord(std::string_view line, size_t begin) {
  const size_t end = line.find('"', begin + 1);
  if (end == std::string_view::npos)
    throw InputError("the name that begins with {} does not end with \"", line.substr(begin));
  return {std::string(line.substr(begin + 1, end - begin - 1)), begin, true};
}

/// Up to a space, a comma, an @, or the + or - between two numbers.
LightWord plainWord(std::string_view line, size_t begin) {
  size_t end = begin;
  for (; end < line.size() && !partsWords(line[end]) && line[end] != '@' && line[end] != '"'; ++end) {
    const bool sign = line[end] == '+' || line[end] == '-';
    if (sign && isDigits(line.substr(begin, end - begin)) && end + 1 < line.size() && isDigit(line[end + 1]))
      break;
  }
  return {std::string(line.substr(begin, end - begin)), begin, false};
}

/// A + - or comma between two numbers: the word before is one that ends here, and another one follows.
bool joinsNumbers(std::string_view line, size_t at, const std::vector<LightWord>& words) {
  const size_t next = line.find_first_not_of(' ', at + 1);
  const bool sign = line[at] == '+' || line[at] == '-' || line[at] == ',';
  return sign && !words.empty() && isDigits(words.back().text) &&
         words.back().begin + words.back().text.size() == at && next != std::string_view::npos &&
         isDigit(line[next]);
}

std::vector<size_t> lightsWhere(const Rig& rig, const auto& is) {
  std::vector<size_t> lights;
  for (size_t i = 0; i < rig.lights.size(); ++i)
    if (is(rig.lights[i])) lights.push_back(i);
  return lights;
}

size_t lightOfNumber(const Rig& rig, const std::string& digits) {
  const size_t number = digits.size() < 6 ? std::stoul(digits) : 0;
  if (number < 1 || number > rig.lights.size())
    throw InputError("there is no light {}: lights are {}", digits, numberedLights(rig));
  return number - 1;
}

/// From the light that was named last to the one that comes now, whichever is first.
std::vector<size_t> rangeTo(const Rig& rig, size_t from, LightWordReader& words) {
  if (words.atEnd()) throw InputError("after thru say up to which light: {}", numberedLights(rig));
  const LightWord word = words.take();
  const auto end = lightsOfWord(rig, word);
  if (!end) throw InputError("'{}' is no light: thru goes up to one of {}", word.text, numberedLights(rig));
  std::vector<size_t> lights;
  for (size_t i = std::min(from, end->front()); i <= std::max(from, end->back()); ++i) lights.push_back(i);
  return lights;
}

}  // namespace

bool sameWord(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lowerCase(x) == lowerCase(y); });
}

std::vector<LightWord> lightWords(std::string_view line) {
  std::vector<LightWord> words;
  size_t at = 0;
  while (at < line.size()) {
    if (partsWords(line[at])) {
      if (joinsNumbers(line, at, words)) words.push_back({"+", at, false});
      ++at;
    } else if (line[at] == '"') {
      words.push_back(quotedWord(line, at));
      at += words.back().text.size() + 2;
    } else if (line[at] == '@') {
      words.push_back({"@", at++, false});
    } else if (joinsNumbers(line, at, words)) {
      words.push_back({line[at] == '+' ? "+" : "thru", at, false});
      ++at;
    } else {
      words.push_back(plainWord(line, at));
      at += words.back().text.size();
    }
  }
  return words;
}

bool LightWordReader::takeIf(std::initializer_list<std::string_view> any) {
  if (atEnd() || peek().quoted) return false;
  const bool found =
      std::any_of(any.begin(), any.end(), [&](std::string_view word) { return sameWord(word, peek().text); });
  if (found) ++m_next;
  return found;
}

std::string numberedLights(const Rig& rig) {
  std::vector<std::string> lights;
  for (size_t i = 0; i < rig.lights.size(); ++i)
    lights.push_back(fmt::format("{} {}", i + 1, rig.lights[i].title()));
  return fmt::format("{}", fmt::join(lights, ", "));
}

std::optional<std::vector<size_t>> lightsOfWord(const Rig& rig, const LightWord& word) {
  if (!word.quoted && isDigits(word.text)) return std::vector{lightOfNumber(rig, word.text)};
  const auto named = [&](const LightSetting& light) { return sameWord(light.light, word.text); };
  const auto labelled = [&](const LightSetting& light) { return sameWord(light.label, word.text); };
  const auto grouped = [&](const LightSetting& light) { return sameWord(light.group, word.text); };
  const auto cast = [&](const LightSetting& light) { return sameWord(roleName(light.role), word.text); };
  if (word.text.empty()) return std::nullopt;
  for (const auto& lights : {lightsWhere(rig, named), lightsWhere(rig, labelled), lightsWhere(rig, grouped)})
    if (!lights.empty()) return lights;
  if (!word.quoted && sameWord(word.text, "all") && !rig.lights.empty())
    return lightsWhere(rig, [](const LightSetting&) { return true; });
  if (const auto lights = lightsWhere(rig, cast); !lights.empty()) return lights;
  return std::nullopt;
}

std::optional<std::vector<size_t>> takeLights(const Rig& rig, LightWordReader& words) {
  std::vector<bool> meant(rig.lights.size(), false);
  bool any = false;
  while (!words.atEnd()) {
    const bool removes = any && words.takeIf({"-", "except"});
    const bool adds = !removes && any && words.takeIf({"+", "and"});
    if (words.atEnd()) throw InputError("after + and - name a light: {}", numberedLights(rig));
    if (any && !adds && !removes && isDigits(words.peek().text)) break;  // "key 50" means a level, wrongly
    auto lights = lightsOfWord(rig, words.peek());
    if (!lights && (adds || removes))
      throw InputError("'{}' is no light: lights are {}", words.peek().text, numberedLights(rig));
    if (!lights) break;
    words.take();
    if (words.takeIf({"thru", "through", ">"})) lights = rangeTo(rig, lights->front(), words);
    for (const size_t i : *lights) meant[i] = !removes;
    any = true;
  }
  if (!any) return std::nullopt;
  std::vector<size_t> lights;
  for (size_t i = 0; i < meant.size(); ++i)
    if (meant[i]) lights.push_back(i);
  return lights;
}

}  // namespace swaplight
