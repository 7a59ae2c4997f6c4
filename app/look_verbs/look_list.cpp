#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/look_verbs/look_actions.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/filter/favourite_looks.h"
#include "core/filter/filter_names.h"
#include "core/filter/filter_pipeline.h"

namespace swaplight {
namespace {

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

Json jsonFromInput(const FilterInput& input) {
  Json json{{"name", input.name},
            {"label", input.label},
            {"type", inputTypeName(input.type)},
            {"default", jsonFromFilterValue(input.standard)}};
  if (input.low) json["min"] = jsonFromFilterValue(*input.low);
  if (input.high) json["max"] = jsonFromFilterValue(*input.high);
  if (!input.values.empty()) json["values"] = input.values;
  if (!input.labels.empty()) json["labels"] = input.labels;
  if (!input.unit.empty()) json["unit"] = input.unit;
  if (!input.tooltip.empty()) json["tooltip"] = input.tooltip;
  return json;
}

Json jsonFromFilter(const Filter& filter) {
  Json inputs = Json::array();
  for (const FilterInput& input : filter.inputs) inputs.push_back(jsonFromInput(input));
  return {{"name", filter.name},
          {"file", filter.file.string()},
          {"built_in", filter.builtIn},
          {"description", filter.description},
          {"credit", filter.credit},
          {"categories", filter.categories},
          {"space", filterSpaceName(filter.space)},
          {"tiles", filter.halo.has_value()},
          {"where", filter.where},
          {"notes", filter.notes},
          {"parameters", std::move(inputs)}};
}

std::string rangeOf(const FilterInput& input) {
  if (!input.values.empty()) {
    std::vector<std::string> choices;
    for (size_t i = 0; i < input.values.size(); ++i)
      choices.push_back(
          fmt::format("{}{}", input.values[i], i < input.labels.size() ? " " + input.labels[i] : ""));
    return "  one of " + joined(choices);
  }
  if (!input.low || !input.high) return "";
  return fmt::format("  {} to {}", textFromFilterValue(*input.low), textFromFilterValue(*input.high));
}

std::string textFromFilter(const Filter& filter) {
  std::string text =
      fmt::format("{}: {}\n  {}\n  works on {} values; {}\n", filter.name, filter.description,
                  filter.file.string(), filterSpaceName(filter.space), joined(filter.categories));
  if (!filter.credit.empty()) text += "  " + filter.credit + '\n';
  for (const std::string& note : filter.notes) text += "  note: " + note + '\n';
  for (const FilterInput& input : filter.inputs)
    text += fmt::format("    {:<14} {:<8} default {}{}{}{}{}\n", input.name, inputTypeName(input.type),
                        textFromFilterValue(input.standard), rangeOf(input),
                        input.unit.empty() ? "" : " " + input.unit, input.tooltip.empty() ? "" : ": ",
                        input.tooltip);
  text.pop_back();
  return text;
}

bool holdsAll(const Filter& filter, const std::vector<std::string>& words) {
  const std::string all = filterKey(filter.name + filter.description + joined(filter.categories));
  return std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return all.find(filterKey(word)) != std::string::npos; });
}

std::string filtersOf(const FilterPipeline& pipeline) {
  std::vector<std::string> names;
  for (const FilterStage& stage : pipeline.stages) names.push_back(stage.filter);
  return joined(names);
}

std::string textFromStage(const FilterStage& stage) {
  std::string text = fmt::format("  {}{}", stage.on ? "" : "(off) ", stage.filter);
  for (const auto& [name, value] : stage.parameters)
    text += fmt::format(" {}={}", name, textFromFilterValue(value));
  return text;
}

int showLook(const FilterPipeline& pipeline, const std::string& where, Terminal& terminal) {
  std::string text = pipeline.name;
  const FilterLibrary library = installedFilters();
  for (const FilterStage& stage : pipeline.stages) {
    static_cast<void>(resolveStage(library, stage, pipeline.folder, where));
    text += '\n' + textFromStage(stage);
  }
  terminal.result(text, jsonFromPipeline(pipeline));
  return 0;
}

/// A camera look of this name, where no filter has it.
std::optional<FilterPipeline> lookNamed(const std::string& name, const FilterLibrary& library) {
  const std::string key = filterKey(name);
  for (const auto& filter : library.filters())
    if (filterKey(filter->name) == key) return std::nullopt;
  for (FilterPipeline& look : pipelinesIn(installedLookFolders()))
    if (filterKey(look.name) == key) return std::move(look);
  return std::nullopt;
}

}  // namespace

int listFilters(const LookArguments& arguments, Terminal& terminal) {
  const FilterLibrary library = installedFilters();
  Json filters = Json::array();
  std::string text;
  for (const auto& filter : library.filters()) {
    if (!holdsAll(*filter, arguments.names)) continue;
    filters.push_back(jsonFromFilter(*filter));
    text +=
        fmt::format("{:<24} {:<13} {}\n", filter->name, filterSpaceName(filter->space), filter->description);
  }
  sayWarnings(library.problems(), terminal);
  if (filters.empty())
    throw InputError("look list: no filter has {} in its name or description", joined(arguments.names));
  Json looks = Json::array();
  const std::vector<std::string> favourites = readFavouriteLooks(favouriteLooksFile());
  for (const FilterPipeline& pipeline : pipelinesIn(installedLookFolders())) {
    looks.push_back(pipeline.name);
    const char* kind = isFavourite(favourites, pipeline.name) ? "camera look *" : "camera look";
    if (arguments.names.empty())
      text += fmt::format("{:<24} {:<13} {}\n", pipeline.name, kind, filtersOf(pipeline));
  }
  text.pop_back();
  terminal.result(text, {{"filters", std::move(filters)},
                         {"camera_looks", std::move(looks)},
                         {"favourites", favourites},
                         {"problems", library.problems()}});
  return 0;
}

int showFilter(const LookArguments& arguments, Terminal& terminal) {
  if (arguments.names.size() != 1)
    throw InputError("look show: name one filter, one camera look, or a .swaplook file");
  const std::string& name = arguments.names[0];
  if (isLookFile(name)) return showLook(readPipeline(name), name, terminal);
  const FilterLibrary library = installedFilters();
  if (const std::optional<FilterPipeline> look = lookNamed(name, library))
    return showLook(*look, look->name, terminal);
  const auto filter = library.find(name, std::filesystem::current_path());
  terminal.result(textFromFilter(*filter), jsonFromFilter(*filter));
  return 0;
}

}  // namespace swaplight
