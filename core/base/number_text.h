#pragma once

#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace swaplight {

/// A finite number, with or without a sign; nothing where there is anything else around it.
[[nodiscard]] inline std::optional<float> numberFromText(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || !(std::isdigit(static_cast<unsigned char>(text.back())) || text.back() == '.'))
    return std::nullopt;  // keeps "inf" and "nan" out
  float value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace swaplight
