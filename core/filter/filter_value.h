#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/curve.h"
#include "core/base/json_fwd.h"

namespace swaplight {

using FilterPoint = std::array<float, 2>;
using FilterColor = std::array<float, 4>;  ///< R G B A, in the filter's colour state

using FilterVector = std::vector<float>;         ///< of 2 to 4 numbers
using FilterMatrix = std::vector<FilterVector>;  ///< 2 to 4 rows of as many numbers
using FilterCurve = CurvePoints;                 ///< at most kMostCurvePoints, x ascending in 0..1

/// What a parameter of a filter holds: a switch or event, a choice, a number, a point, a colour, the file of
/// a picture (empty: none), a vector, a matrix, a curve.
using FilterValue = std::variant<bool, int, float, FilterPoint, FilterColor, std::string, FilterVector,
                                 FilterMatrix, FilterCurve>;

/// The types of ISF 2's INPUTS (https://docs.isf.video/ref_json.html), and three that it lacks.
enum class FilterInputType {
  Event,
  Bool,
  Choice,
  Float,
  Point2D,
  Color,
  Image,
  Audio,
  AudioSpectrum,
  Vector,
  Matrix,
  Curve
};

inline constexpr size_t kMostCurvePoints = 16;

/// A type's name in a filter's file: "float", "point2D", "vector" ...
[[nodiscard]] const char* inputTypeName(FilterInputType type);
/// Of ISF's types.
[[nodiscard]] std::optional<FilterInputType> inputTypeFromIsf(const std::string& name);
/// Of those that ISF lacks.
[[nodiscard]] std::optional<FilterInputType> ownInputType(const std::string& name);

[[nodiscard]] Json jsonFromFilterValue(const FilterValue& value);
/// Of any type; numbers that are whole become int only for choices. `where` begins the message. Throws
/// InputError that says what was expected.
[[nodiscard]] FilterValue filterValueFromJson(const Json& json, FilterInputType type,
                                              const std::string& where);

/// As a person types and reads it: "on", "3", "0.5", "0.5:0.25", "1:0.5:0:1" (a colour; also #ff8000), a
/// file; a vector as "1:0.5:0", a matrix by its rows, "1:0/0:1", a curve by its points, "0:0/0.5:0.7/1:1".
[[nodiscard]] std::string textFromFilterValue(const FilterValue& value);
/// Throws InputError as filterValueFromJson does.
[[nodiscard]] FilterValue filterValueFromText(const std::string& text, FilterInputType type,
                                              const std::string& where);
/// A text, or a value of a kind that JSON does not tell apart, as the type's own. Throws the same.
[[nodiscard]] FilterValue valueOfType(const FilterValue& value, FilterInputType type,
                                      const std::string& where);

}  // namespace swaplight
