#include "core/export/layer_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string_view>

namespace swaplight {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

std::string lowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool isReserved(const std::string& name) {
  constexpr std::array<std::string_view, 23> kReserved = {
      "r",    "g",     "b",       "a",       "rgb",     "rgba",     "red",        "green",
      "blue", "alpha", "depth",   "motion",  "forward", "backward", "mask",       "other",
      "z",    "beta",  "quality", "ambient", "main",    "beauty",   "camera_look"};
  return std::find(kReserved.begin(), kReserved.end(), lowerCase(name)) != kReserved.end();
}

}  // namespace

std::string nukeName(const std::string& name) {
  std::string mangled(std::find_if_not(name.begin(), name.end(), isDigit), name.end());
  for (char& c : mangled)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 || static_cast<unsigned char>(c) > 127) c = '_';
  return mangled;
}

std::vector<std::string> layerNames(std::span<const std::string> lights) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const std::string& light : lights) {
    std::string name = nukeName(light);
    if (name.empty() || std::isalpha(static_cast<unsigned char>(name.front())) == 0 || isReserved(name))
      name.insert(0, "light_");
    const std::string plain = name;
    for (int number = 2; !taken.insert(lowerCase(name)).second; ++number)
      name = plain + "_" + std::to_string(number);
    names.push_back(name);
  }
  return names;
}

}  // namespace swaplight
