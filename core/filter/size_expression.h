#pragma once

#include <functional>
#include <optional>
#include <string>

namespace swaplight {

/// The value of a variable of an expression, by its name without "$"; nothing where it is unknown.
using ExpressionVariables = std::function<std::optional<double>(const std::string& name)>;

/// The value of an arithmetic expression as ISF's PASSES have them for WIDTH and HEIGHT:
/// "max(floor($WIDTH * $scale / 3.0), 1)". Numbers, $variables, + - * / % and brackets, and the functions abs
/// ceil floor round sqrt min max pow. Throws InputError that quotes the expression, says what was found and
/// where. What is not finite becomes 0.
[[nodiscard]] double expressionValue(const std::string& text, const ExpressionVariables& variables);

}  // namespace swaplight
