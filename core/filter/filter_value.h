#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "core/base/json_fwd.h"

namespace swaplight {

using FilterPoint = std::array<float, 2>;
using FilterColor = std::array<float, 4>;  ///< R G B A, in the filter's colour state

/// What a parameter of a filter holds: a switch or event, a choice, a number, a point, a colour, or the file
/// of a picture (empty: none).
using FilterValue = std::variant<bool, int, float, FilterPoint, FilterColor, std::string>;

/// The types of ISF 2's INPUTS. https://docs.isf.video/ref_json.html
enum class FilterInputType { Event, Bool, Choice, Float, Point2D, Color, Image, Audio, AudioSpectrum };

/// ISF's name of a type: "float", "point2D" ...
[[nodiscard]] const char* isfTypeName(FilterInputType type);
[[nodiscard]] std::optional<FilterInputType> inputTypeFromIsf(const std::string& name);

[[nodiscard]] Json jsonFromFilterValue(const FilterValue& value);
/// Of any type; numbers that are whole become int only for choices. `where` begins the message. Throws
/// InputError that says what was expected.
[[nodiscard]] FilterValue filterValueFromJson(const Json& json, FilterInputType type,
                                              const std::string& where);

/// As a person types and reads it: "on", "3", "0.5", "0.5:0.25", "1:0.5:0:1" (a colour; also #ff8000), a
/// file.
[[nodiscard]] std::string textFromFilterValue(const FilterValue& value);
/// Throws InputError as filterValueFromJson does.
[[nodiscard]] FilterValue filterValueFromText(const std::string& text, FilterInputType type,
                                              const std::string& where);

}  // namespace swaplight
