#include "core/capture/light_name.h"

#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/base/lower_case.h"

namespace swaplight {
namespace {

bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool isNameCharacter(char c) {
  return isLetter(c) || (c >= '0' && c <= '9') || c == '_';
}

// EXR allows 255 bytes for a channel's name, which has more in it than the light's.
constexpr size_t kLongestName = 200, kShownOfLong = 40;

/// The nearest name that is allowed.
std::string suggestion(std::string name) {
  for (char& c : name)
    if (!isNameCharacter(c)) c = '_';
  return !name.empty() && isLetter(name.front()) ? name : "light_" + name;
}

void checkLightName(const std::string& name, const std::string& where) {
  if (name.empty()) throw InputError("{}: a light has an empty name. Give it one, such as key.", where);
  if (name.find('.') != std::string::npos)
    throw InputError(
        "{}: the light name \"{}\" has a dot, which separates layer from channel in EXR files. Call it "
        "\"{}\".",
        where, name, suggestion(name));
  if (!isLetter(name.front()) || !std::all_of(name.begin(), name.end(), isNameCharacter))
    throw InputError(
        "{}: the light name \"{}\" is not allowed: a letter, then letters, digits and underscores. "
        "Call it \"{}\".",
        where, name, suggestion(name));
  if (name.size() > kLongestName)
    throw InputError(
        "{}: the light name \"{} …\" has {} letters, at most {} are allowed. Give it a shorter one.", where,
        name.substr(0, kShownOfLong), name.size(), kLongestName);
  const std::string lower = lowerCase(name);
  if (lower == "ambient" || lower == "beta" || lower == "quality")
    throw InputError(
        "{}: a light cannot be called \"{}\": solved files keep that layer for themselves. Rename it.", where,
        name);
}

}  // namespace

void checkLightNames(std::span<const std::string> names, const std::string& where) {
  std::map<std::string, std::string> seen;
  for (const std::string& name : names) {
    checkLightName(name, where);
    const auto [first, isNew] = seen.emplace(lowerCase(name), name);
    if (isNew) continue;
    if (first->second == name) throw InputError("{}: two lights are called \"{}\". Rename one.", where, name);
    throw InputError("{}: the lights \"{}\" and \"{}\" differ in case only. Rename one.", where,
                     first->second, name);
  }
}

}  // namespace swaplight
