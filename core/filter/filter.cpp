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
  if (const auto* vector = std::get_if<FilterVector>(&value)) return *vector;
  std::vector<float> numbers;
  if (const auto* matrix = std::get_if<FilterMatrix>(&value))
    for (const FilterVector& row : *matrix) numbers.insert(numbers.end(), row.begin(), row.end());
  if (const auto* curve = std::get_if<FilterCurve>(&value))
    for (const auto& point : *curve) numbers.push_back(point[1]);
  return numbers;
}

/// A single bound is that of every number.

bool within(const FilterValue& value, const FilterValue& bound, bool bound_is_low) {
  const std::vector<float> numbers = numbersOf(value), limits = numbersOf(bound);
  if (limits.empty()) return true;
  for (size_t i = 0; i < numbers.size(); ++i) {
    const float limit = limits[std::min(i, limits.size() - 1)];
    if (bound_is_low ? numbers[i] < limit : numbers[i] > limit) return false;
  }
  return true;
}

/// A vector or matrix of another size is of another type.
bool isAlike(const FilterValue& a, const FilterValue& b) {
  const bool sized = std::holds_alternative<FilterVector>(a) || std::holds_alternative<FilterMatrix>(a);
  return a.index() == b.index() && (!sized || numbersOf(a).size() == numbersOf(b).size());
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
  if (!isAlike(value, standard))
    throw InputError("{}: is {}, which is not of the type {}, as {}", where, textFromFilterValue(value),
                     inputTypeName(type), textFromFilterValue(standard));
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
