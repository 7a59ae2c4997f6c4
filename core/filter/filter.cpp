#include "core/filter/filter.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"

namespace swaplight {
namespace {

/// The numbers of a value, for comparing it with its range.
std::vector<float> numbersOf(const FilterValue& value) {
  if (const float* number = std::get_if<float>(&value)) return {*number};
  if (const auto* point = std::get_if<FilterPoint>(&value)) return {(*point)[0], (*point)[1]};
  return {};
}

bool within(const FilterValue& value, const FilterValue& bound, bool bound_is_low) {
  const std::vector<float> numbers = numbersOf(value), limits = numbersOf(bound);
  for (size_t i = 0; i < std::min(numbers.size(), limits.size()); ++i)
    if (bound_is_low ? numbers[i] < limits[i] : numbers[i] > limits[i]) return false;
  return true;
}

std::string choicesOf(const FilterInput& input) {
  std::string words;
  for (size_t i = 0; i < input.values.size(); ++i)
    words += fmt::format("{}{}{}", i == 0 ? "" : ", ", input.values[i],
                         i < input.labels.size() ? " (" + input.labels[i] + ")" : "");
  return words;
}

}  // namespace

const char* filterSpaceName(FilterSpace space) {
  switch (space) {
    case FilterSpace::SceneLinear:
      return "scene_linear";
    case FilterSpace::Display:
      return "display";
    case FilterSpace::Any:
      return "any";
  }
  return "";
}

void FilterInput::check(const FilterValue& value, const std::string& where, bool strict) const {
  if (value.index() != standard.index())
    throw InputError("{}: is {}, which is not of the type {}", where, textFromFilterValue(value),
                     isfTypeName(type));
  if (!strict) return;
  if (const int* choice = std::get_if<int>(&value);
      choice && !values.empty() && std::find(values.begin(), values.end(), *choice) == values.end())
    throw InputError("{}: is {}, expected one of {}", where, *choice, choicesOf(*this));
  if ((low && !within(value, *low, true)) || (high && !within(value, *high, false)))
    throw InputError("{}: is {}, expected {} to {}{}", where, textFromFilterValue(value),
                     low ? textFromFilterValue(*low) : "any", high ? textFromFilterValue(*high) : "any",
                     unit.empty() ? "" : " " + unit);
}

const FilterInput* Filter::findInput(const std::string& inputName) const {
  for (const FilterInput& input : inputs)
    if (input.name == inputName) return &input;
  return nullptr;
}

}  // namespace swaplight
