#pragma once

#include <array>
#include <string>
#include <string_view>

namespace swaplight {

// Places in the photographs as options name them, in pixels from the top left corner.

/// "120,80". `where` begins the message. Throws InputError.
[[nodiscard]] std::array<int, 2> placeFromText(std::string_view text, const std::string& where);

/// A place that belongs to a light.
struct LightPlace {
  std::string light;
  int x = 0, y = 0;
};

/// "key=120,80". Throws InputError that quotes the option.
[[nodiscard]] LightPlace lightPlaceFromText(const std::string& text, const char* option);

}  // namespace swaplight
