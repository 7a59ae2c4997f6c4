#include "app/program/number_range.h"

#include <fmt/core.h>

namespace swaplight {

NumberRange::NumberRange(double low, double high) : Validator("") {
  func_ = [low, high](const std::string& text) -> std::string {
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high) return {};
    return fmt::format("Value {} not in range {} to {}", text, low, high);
  };
}

}  // namespace swaplight
