#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace swaplight {

/// A to Z as a to z; all else, of any encoding, stays.
[[nodiscard]] inline char lowerCase(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

[[nodiscard]] inline std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = lowerCase(c);
  return lower;
}

/// Of a file, with its dot: ".exr"; "" without one.
[[nodiscard]] inline std::string lowerExtension(const std::filesystem::path& file) {
  return lowerCase(file.extension().string());
}

}  // namespace swaplight
