#include "core/filter/former_parameters.h"

#include <array>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/filter/filter_library.h"

namespace swaplight {
namespace {

using Parameters = std::map<std::string, FilterValue>;

/// A parameter, which is taken out; `standard` where it is not given.
template <typename Value>
Value taken(Parameters& parameters, const std::string& name, FilterInputType type, const Value& standard) {
  const auto found = parameters.find(name);
  if (found == parameters.end()) return standard;
  const FilterValue value = valueOfType(found->second, type, name);
  parameters.erase(found);
  return std::get<Value>(value);
}

bool hasAny(const Parameters& parameters, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (parameters.contains(name)) return true;
  return false;
}

/// Red, green and blue of a colour, each times `factor` after `zero` is taken off.
void makeVector(Parameters& parameters, const char* former, const char* now, float zero, float factor) {
  if (!parameters.contains(former)) return;
  const FilterColor color = taken(parameters, former, FilterInputType::Color, FilterColor{});
  parameters[now] =
      FilterVector{factor * (color[0] - zero), factor * (color[1] - zero), factor * (color[2] - zero)};
}

void updateCdl(Parameters& parameters) {
  makeVector(parameters, "slope", "slopes", 0, 1);
  makeVector(parameters, "offset", "offsets", 0.5F, 1);  // 0.5 added nothing
  makeVector(parameters, "power", "powers", 0, 2);       // half of the exponent
}

void updateChannelMixer(Parameters& parameters) {
  if (!hasAny(parameters, {"red", "green", "blue"})) return;
  FilterMatrix rows;
  for (const auto& [name, standard] : std::initializer_list<std::pair<const char*, FilterColor>>{
           {"red", {1, 0, 0, 1}}, {"green", {0, 1, 0, 1}}, {"blue", {0, 0, 1, 1}}}) {
    const FilterColor row = taken(parameters, name, FilterInputType::Color, standard);
    rows.push_back({row[0], row[1], row[2]});
  }
  parameters["matrix"] = rows;
}

void updateCurves(Parameters& parameters) {
  if (!hasAny(parameters, {"black", "shadows", "middle", "highlights", "white"})) return;
  FilterCurve points;
  for (const auto& [name, x, standard] :
       std::initializer_list<std::tuple<const char*, float, float>>{{"black", 0.0F, 0.0F},
                                                                    {"shadows", 0.25F, 0.2F},
                                                                    {"middle", 0.5F, 0.5F},
                                                                    {"highlights", 0.75F, 0.8F},
                                                                    {"white", 1.0F, 1.0F}})
    points.push_back({x, taken(parameters, name, FilterInputType::Float, standard)});
  parameters["tone"] = points;
}

}  // namespace

FilterStage withoutFormerParameters(FilterStage stage) {
  const std::string filter = filterKey(stage.filter);
  const FilterStage before = stage;
  try {
    if (filter == "cdl") updateCdl(stage.parameters);
    if (filter == "channelmixer") updateChannelMixer(stage.parameters);
    if (filter == "curves") updateCurves(stage.parameters);
  } catch (const InputError&) {  // what is no value is said when the filter is known
    return before;
  }
  return stage;
}

}  // namespace swaplight
