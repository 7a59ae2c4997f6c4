#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "core/base/json.h"

namespace swaplight {

/// A whole number that an int holds; nothing where there is anything else. nlohmann's get<int>() takes the
/// lowest 32 bits of a larger number, and the whole part of a fraction.
[[nodiscard]] inline std::optional<int> integerOf(const Json& json) {
  if (json.is_number_unsigned()) {  // may be beyond int64_t
    const auto number = json.get<uint64_t>();
    return std::in_range<int>(number) ? std::optional(static_cast<int>(number)) : std::nullopt;
  }
  if (!json.is_number_integer()) return std::nullopt;
  const auto number = json.get<int64_t>();
  return std::in_range<int>(number) ? std::optional(static_cast<int>(number)) : std::nullopt;
}

}  // namespace swaplight
