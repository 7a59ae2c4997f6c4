#include "app/arguments/place_text.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/number_text.h"

namespace swaplight {
namespace {

constexpr float kMostPixels = 1e6F;

/// A pixel's column or row; nothing where it is no whole number.
std::optional<int> pixelFromText(std::string_view text) {
  const std::optional<float> number = numberFromText(text);
  if (!number || *number != std::floor(*number) || std::abs(*number) > kMostPixels) return std::nullopt;
  return static_cast<int>(*number);
}

}  // namespace

std::array<int, 2> placeFromText(std::string_view text, const std::string& where) {
  const size_t comma = std::min(text.find(','), text.size());
  const std::optional<int> x = pixelFromText(text.substr(0, comma));
  const std::optional<int> y = pixelFromText(text.substr(std::min(comma + 1, text.size())));
  if (!x || !y) throw InputError("{}: write X,Y in pixels", where);
  return {*x, *y};
}

LightPlace lightPlaceFromText(const std::string& text, const char* option) {
  const size_t equals = text.find('=');
  if (equals == std::string::npos) throw InputError("{} {}: write LIGHT=X,Y in pixels", option, text);
  const auto [x, y] = placeFromText(text.substr(equals + 1), fmt::format("{} {}", option, text));
  return {text.substr(0, equals), x, y};
}

}  // namespace swaplight
