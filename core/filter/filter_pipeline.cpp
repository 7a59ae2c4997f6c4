#include "core/filter/filter_pipeline.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_fields.h"
#include "core/file/json_file.h"
#include "core/filter/filter_names.h"
#include "core/filter/former_parameters.h"

namespace swaplight {
namespace {

constexpr const char* kFormat = "swaplight-look";
constexpr size_t kMostStages = 1000;

/// By what the JSON is; the filter's own type is asked when it is known.
FilterValue anyValueFromJson(const Json& json, const std::string& where) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number()) return filterValueFromJson(json, FilterInputType::Float, where);
  if (json.is_string()) return json.get<std::string>();
  const size_t count = json.is_array() ? json.size() : 0;
  if (count > 0 && json.front().is_array()) {
    const bool square = json.front().size() == count;
    return filterValueFromJson(json, square ? FilterInputType::Matrix : FilterInputType::Curve, where);
  }
  if (count == 2) return filterValueFromJson(json, FilterInputType::Point2D, where);
  return filterValueFromJson(json, count == 3 ? FilterInputType::Vector : FilterInputType::Color, where);
}

FilterStage stageFromJson(const Json& json, const std::string& where) {
  JsonFields fields(json, where);
  FilterStage stage;
  stage.filter = fields.text("filter").value_or("");
  if (stage.filter.empty())
    throw InputError("{}: \"filter\" is missing, expected the name of a filter (swaplight look list)", where);
  fields.setWhere(fmt::format("{} ({})", where, stage.filter));
  stage.on = fields.boolean("on").value_or(true);
  if (const Json* parameters = fields.find("parameters")) {
    if (!parameters->is_object())
      throw InputError("{}: \"parameters\" is {}, expected an object {{...}}", fields.where(),
                       describeJson(*parameters));
    for (const auto& [name, value] : parameters->items())
      stage.parameters.emplace(name,
                               anyValueFromJson(value, fmt::format("{}: \"{}\"", fields.where(), name)));
  }
  stage.kept = fields.unknown();
  return withoutFormerParameters(std::move(stage));
}

Json jsonFromStage(const FilterStage& stage) {
  Json json{{"filter", stage.filter}, {"on", stage.on}};
  Json parameters = Json::object();
  for (const auto& [name, value] : stage.parameters) parameters[name] = jsonFromFilterValue(value);
  if (!parameters.empty()) json["parameters"] = std::move(parameters);
  json.update(stage.kept.json());
  return json;
}

}  // namespace

Json jsonFromPipeline(const FilterPipeline& pipeline) {
  Json stages = Json::array();
  for (const FilterStage& stage : pipeline.stages) stages.push_back(jsonFromStage(stage));
  Json json{{"format", kFormat},
            {"version", kPipelineVersion},
            {"name", pipeline.name},
            {"filters", std::move(stages)}};
  json.update(pipeline.kept.json());
  return json;
}

FilterPipeline pipelineFromJson(const Json& json, const std::string& where) {
  JsonFields fields(json, where);
  const std::string format = fields.text("format").value_or("");
  if (format != kFormat)
    throw InputError("{}: \"format\" is \"{}\", expected \"{}\": this is no camera look", where, format,
                     kFormat);
  if (fields.number("version", 1, 1e6).value_or(kPipelineVersion) > kPipelineVersion)
    throw InputError("{}: was written by a newer version of swaplight; update this one", where);
  FilterPipeline pipeline;
  pipeline.name = fields.text("name").value_or("");
  if (pipeline.name.empty()) throw InputError("{}: \"name\" is missing, expected the look's name", where);
  int index = 0;
  for (const Json& stage : fields.list("filters", "a list of filters", kMostStages))
    pipeline.stages.push_back(stageFromJson(stage, fmt::format("{}: filter {}", where, ++index)));
  if (pipeline.stages.empty())
    throw InputError("{}: \"filters\" is empty, expected at least one filter", where);
  pipeline.kept = fields.unknown();
  return pipeline;
}

std::vector<std::filesystem::path> filesOfPipeline(const FilterPipeline& pipeline) {
  std::vector<std::filesystem::path> files;
  for (const FilterStage& stage : pipeline.stages) {
    if (isFilterFile(stage.filter)) files.push_back(pipeline.folder / stage.filter);
    for (const auto& [name, value] : stage.parameters)
      if (const auto* text = std::get_if<std::string>(&value); text && !text->empty())
        files.push_back(pipeline.folder / *text);
  }
  return files;
}

FilterPipeline readPipeline(const std::filesystem::path& file) {
  FilterPipeline pipeline = pipelineFromJson(readJson(file), file.string());
  pipeline.folder = file.parent_path();
  return pipeline;
}

void writePipeline(const FilterPipeline& pipeline, const std::filesystem::path& file) {
  writeJson(jsonFromPipeline(pipeline), file);
}

FilterStage stageFromText(const std::string& text) {
  FilterStage stage;
  size_t begin = 0;
  for (bool first = true; begin <= text.size(); first = false) {
    const size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    begin = end + 1;
    if (first) {
      stage.filter = part;
      continue;
    }
    const size_t equals = part.find('=');
    if (equals == std::string::npos || equals == 0)
      throw InputError("--filter {}: \"{}\" is no parameter, expected NAME,parameter=value", text, part);
    stage.parameters[part.substr(0, equals)] = part.substr(equals + 1);
  }
  if (stage.filter.empty())
    throw InputError("--filter \"{}\": no filter named, expected NAME,parameter=value", text);
  return withoutFormerParameters(std::move(stage));
}

}  // namespace swaplight
