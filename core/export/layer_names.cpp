#include "core/export/layer_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <string_view>

#include "core/base/lower_case.h"

namespace swaplight {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

bool isReserved(const std::string& name) {
  constexpr std::array<std::string_view, 23> kReserved = {
      "r",    "g",     "b",       "a",       "rgb",     "rgba",     "red",        "green",
      "blue", "alpha", "depth",   "motion",  "forward", "backward", "mask",       "other",
      "z",    "beta",  "quality", "ambient", "main",    "beauty",   "camera_look"};
  return std::find(kReserved.begin(), kReserved.end(), lowerCase(name)) != kReserved.end();
}

/// The name, or with the first number from 2 on that makes it another than those taken; it is taken then.
std::string untaken(const std::string& plain, std::set<std::string>& taken) {
  std::string name = plain;
  for (int number = 2; !taken.insert(lowerCase(nukeName(name))).second; ++number)
    name = plain + "_" + std::to_string(number);
  return name;
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
    names.push_back(untaken(name, taken));
  }
  return names;
}

std::vector<std::string> highlightLayerNames(std::span<const std::string> layers, char separator) {
  std::set<std::string> taken;
  for (const std::string& layer : layers) taken.insert(lowerCase(nukeName(layer)));
  std::vector<std::string> names;
  for (const std::string& layer : layers) names.push_back(untaken(layer + separator + "spec", taken));
  return names;
}

}  // namespace swaplight
