#pragma once

#include <algorithm>
#include <array>
#include <string>

namespace swaplight {

// Words for choices in files: the name stands at the enumerator's place.

template <typename Enum, size_t N>
[[nodiscard]] const char* nameOfEnum(const std::array<const char*, N>& names, Enum value) {
  return names.at(static_cast<size_t>(value));
}

template <typename Enum, size_t N>
[[nodiscard]] Enum enumOfName(const std::array<const char*, N>& names, const std::string& name,
                              Enum otherwise) {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? otherwise : static_cast<Enum>(found - names.begin());
}

/// Of ViewSubject::Kind.
inline constexpr std::array<const char*, 13> kSubjectNames = {
    "relit",      "contribution", "beta",         "reflectance", "residual",  "sigma",  "flags",
    "photograph", "visibility",   "illumination", "lighting",    "highlight", "diffuse"};

}  // namespace swaplight
