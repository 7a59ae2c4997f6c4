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

/// As a sentence begins: "key light" as "Key light".
[[nodiscard]] inline std::string withCapital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

/// Of a file, with its dot: ".exr"; "" without one.
[[nodiscard]] inline std::string lowerExtension(const std::filesystem::path& file) {
  return lowerCase(file.extension().string());
}

}  // namespace swaplight
