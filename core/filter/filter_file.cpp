#include "core/filter/filter_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/atomic_file.h"
#include "core/file/json_fields.h"
#include "core/filter/filter_header.h"
#include "core/filter/size_expression.h"

namespace swaplight {
namespace {

namespace fs = std::filesystem;

constexpr size_t kMostInputs = 256, kMostPasses = 64;

/// A name that GLSL takes.
bool isIdentifier(const std::string& name) {
  const auto ok = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  return !name.empty() && !std::isdigit(static_cast<unsigned char>(name[0])) &&
         std::all_of(name.begin(), name.end(), ok);
}

std::string nameOf(JsonFields& fields, const std::string& key = "NAME") {
  const std::string name = fields.text(key).value_or("");
  if (!isIdentifier(name))
    throw InputError("{}: \"{}\" is \"{}\", expected a name of letters, digits and _ that the shader can use",
                     fields.where(), key, name);
  return name;
}

FilterValue standardValue(FilterInputType type) {
  switch (type) {
    case FilterInputType::Event:
    case FilterInputType::Bool:
      return false;
    case FilterInputType::Choice:
      return 0;
    case FilterInputType::Float:
      return 0.0F;
    case FilterInputType::Point2D:
      return FilterPoint{0, 0};
    case FilterInputType::Color:
      return FilterColor{0, 0, 0, 1};
    case FilterInputType::Image:
    case FilterInputType::Audio:
    case FilterInputType::AudioSpectrum:
      return std::string();
    case FilterInputType::Vector:
      return FilterVector{0, 0, 0};
    case FilterInputType::Matrix:
      return FilterMatrix{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    case FilterInputType::Curve:
      return FilterCurve{{0, 0}, {1, 1}};
  }
  return 0.0F;
}

void readChoices(FilterInput& input, JsonFields& fields) {
  if (const Json* values = fields.find("VALUES"); values && values->is_array())
    for (const Json& value : *values)
      input.values.push_back(std::get<int>(
          filterValueFromJson(value, FilterInputType::Choice, fields.where() + ": \"VALUES\"")));
  if (const Json* labels = fields.find("LABELS"); labels && labels->is_array())
    for (const Json& label : *labels)
      input.labels.push_back(label.is_string() ? label.get<std::string>() : label.dump());
}

bool hasRange(FilterInputType type) {
  return type == FilterInputType::Float || type == FilterInputType::Point2D;
}

/// The bounds of every number of a vector or a matrix, and of a curve's height.
void readBounds(FilterInput& input, JsonFields& fields) {
  const auto bound = [&](const char* key) -> std::optional<FilterValue> {
    const Json* found = fields.find(key);
    if (!found) return {};
    return filterValueFromJson(*found, FilterInputType::Float,
                               fmt::format("{}: \"{}\"", fields.where(), key));
  };
  input.low = bound("MIN");
  input.high = bound("MAX");
  if (input.type != FilterInputType::Curve) return;
  if (!input.low) input.low = 0.0F;
  if (!input.high) input.high = 1.0F;
}

FilterInput inputFromJson(const Json& json, const std::string& where, bool own) {
  JsonFields fields(json, where);
  FilterInput input;
  input.name = nameOf(fields);
  fields.setWhere(fmt::format("{} \"{}\"", where, input.name));
  const std::string type = fields.text("TYPE").value_or("");
  const std::optional<FilterInputType> known = own ? ownInputType(type) : inputTypeFromIsf(type);
  if (!known)
    throw InputError("{}: \"TYPE\" is \"{}\", expected {}", fields.where(), type,
                     own                  ? "vector, matrix or curve; others stand in \"INPUTS\""
                     : ownInputType(type) ? "a type of ISF: list it in the key \"SWAPLIGHT\", \"INPUTS\""
                                          : "event, bool, long, float, point2D, color, image, audio or "
                                            "audioFFT");
  input.type = *known;
  input.label = fields.text("LABEL").value_or(input.name);
  input.standard = standardValue(input.type);
  const auto value = [&](const char* key) -> std::optional<FilterValue> {
    const Json* found = fields.find(key);
    if (!found || found->is_null()) return {};
    return filterValueFromJson(*found, input.type, fmt::format("{}: \"{}\"", fields.where(), key));
  };
  if (input.type == FilterInputType::Choice) readChoices(input, fields);
  if (hasRange(input.type)) {
    input.low = value("MIN");
    input.high = value("MAX");
    if (input.low) input.standard = *input.low;
  }
  if (own) readBounds(input, fields);
  if (!input.values.empty()) input.standard = input.values[0];
  const bool typed = input.type != FilterInputType::Image && input.type != FilterInputType::Audio &&
                     input.type != FilterInputType::AudioSpectrum;
  if (typed)
    if (const std::optional<FilterValue> standard = value("DEFAULT")) input.standard = *standard;
  if (own) input.check(input.standard, fmt::format("{}: \"DEFAULT\"", fields.where()), true);
  return input;
}

/// A number or an expression.
std::string expressionOf(JsonFields& fields, const std::string& key) {
  const Json* value = fields.find(key);
  if (!value) return {};
  if (value->is_number()) return fmt::format("{}", value->get<double>());
  if (value->is_string()) return value->get<std::string>();
  throw InputError("{}: \"{}\" is {}, expected a number or an expression", fields.where(), key,
                   describeJson(*value));
}

bool truthOf(JsonFields& fields, const std::string& key) {
  const Json* value = fields.find(key);
  return value &&
         ((value->is_boolean() && value->get<bool>()) || (value->is_number() && value->get<double>() != 0) ||
          (value->is_string() && (*value == "1" || *value == "true")));
}

FilterPass passFromJson(const Json& json, const std::string& where) {
  JsonFields fields(json, where);
  FilterPass pass;
  const std::optional<std::string> target = fields.text("TARGET");
  if (target && !target->empty()) pass.target = nameOf(fields, "TARGET");
  pass.widthExpression = expressionOf(fields, "WIDTH");
  pass.heightExpression = expressionOf(fields, "HEIGHT");
  pass.persistent = truthOf(fields, "PERSISTENT");
  pass.isFloat = truthOf(fields, "FLOAT");
  return pass;
}

/// ISF 1 lists targets that persist apart: names, or an object with sizes.
void readPersistentBuffers(Filter& filter, JsonFields& fields) {
  const Json* buffers = fields.find("PERSISTENT_BUFFERS");
  if (!buffers) return;
  for (auto at = buffers->begin(); at != buffers->end(); ++at) {
    const std::string name = buffers->is_object() ? at.key() : at->is_string() ? at->get<std::string>() : "";
    for (FilterPass& pass : filter.passes)
      if (pass.target == name && !name.empty()) {
        pass.persistent = true;
        if (!buffers->is_object() || !at->is_object()) continue;
        JsonFields size(*at, fields.where() + ": \"PERSISTENT_BUFFERS\"");
        if (pass.widthExpression.empty()) pass.widthExpression = expressionOf(size, "WIDTH");
        if (pass.heightExpression.empty()) pass.heightExpression = expressionOf(size, "HEIGHT");
        pass.isFloat = pass.isFloat || truthOf(size, "FLOAT");
      }
  }
}

FilterImport importFromJson(const Json& json, std::string name, const Filter& filter,
                            const std::string& where) {
  JsonFields fields(json, where);
  if (name.empty()) name = nameOf(fields);
  const Json* path = fields.find("PATH");
  if (!path || !path->is_string())
    throw InputError("{} \"{}\": \"PATH\" is {}, expected the name of one picture", where, name,
                     path ? describeJson(*path) : "missing");
  return {name, filter.file.parent_path() / path->get<std::string>()};
}

void readImports(Filter& filter, JsonFields& fields) {
  const Json* imports = fields.find("IMPORTED");
  if (!imports) return;
  const std::string where = fields.where() + ": \"IMPORTED\"";
  for (auto at = imports->begin(); at != imports->end(); ++at)
    filter.imports.push_back(importFromJson(*at, imports->is_object() ? at.key() : "", filter, where));
}

void readTexts(Filter& filter, JsonFields& fields, const char* key, std::string FilterInput::*member) {
  const Json* texts = fields.find(key);
  if (!texts) return;
  JsonFields known(*texts, fmt::format("{} \"{}\"", fields.where(), key));
  for (FilterInput& input : filter.inputs)
    if (const std::optional<std::string> text = known.text(input.name)) input.*member = *text;
  if (!known.unknown().empty())
    throw InputError("{} \"{}\": there is no input \"{}\"", fields.where(), key,
                     known.unknown().begin().key());
}

void readOwnKey(Filter& filter, JsonFields& fields) {
  const Json* own = fields.find("SWAPLIGHT");
  if (!own) return;
  filter.ours = true;
  JsonFields key(*own, fields.where() + ": \"SWAPLIGHT\"");
  const std::string space = key.text("SPACE").value_or("display");
  if (space == "scene_linear")
    filter.space = FilterSpace::SceneLinear;
  else if (space == "any")
    filter.space = FilterSpace::Any;
  else if (space != "display")
    throw InputError("{}: \"SPACE\" is \"{}\", expected scene_linear, display or any", key.where(), space);
  if (key.find("HALO")) filter.halo = expressionOf(key, "HALO");
  const std::string sampling = key.text("SAMPLING").value_or("linear");
  if (sampling != "linear" && sampling != "nearest")
    throw InputError("{}: \"SAMPLING\" is \"{}\", expected linear or nearest", key.where(), sampling);
  filter.nearest = sampling == "nearest";
  if (key.find("OVERVIEW")) filter.overview = nameOf(key, "OVERVIEW");
  if (key.find("LIGHT")) filter.light = nameOf(key, "LIGHT");
  if (const Json* where = key.find("WHERE")) {
    filter.where.clear();
    for (const Json& place : *where) {
      if (place != "shot" && place != "light" && place != "frame")
        throw InputError("{}: \"WHERE\" holds {}, expected shot, light or frame", key.where(), place.dump());
      filter.where.push_back(place.get<std::string>());
    }
  }
  if (key.find("INPUTS")) {
    int index = 0;
    for (const Json& input : key.list("INPUTS", "a list of inputs", kMostInputs))
      filter.inputs.push_back(inputFromJson(input, fmt::format("{}: input {}", key.where(), ++index), true));
  }
  readTexts(filter, key, "UNIT", &FilterInput::unit);
  readTexts(filter, key, "TOOLTIP", &FilterInput::tooltip);
}

/// An expression that cannot be read is said now, not when a picture is drawn.
void checkExpressions(const Filter& filter, const std::string& name) {
  const auto one = [&](const std::string& variable) -> std::optional<double> {
    const FilterInput* input = filter.findInput(variable);
    const bool number = input && (std::holds_alternative<float>(input->standard) ||
                                  std::holds_alternative<int>(input->standard) ||
                                  std::holds_alternative<bool>(input->standard));
    return variable == "WIDTH" || variable == "HEIGHT" || number ? std::optional(1.0) : std::nullopt;
  };
  try {
    for (const FilterPass& pass : filter.passes)
      for (const std::string& text : {pass.widthExpression, pass.heightExpression})
        if (!text.empty()) static_cast<void>(expressionValue(text, one));
    if (filter.halo) static_cast<void>(expressionValue(*filter.halo, one));
  } catch (const InputError& error) {
    throw InputError("{}: {}", name, error.what());
  }
}

void checkNames(const Filter& filter, const std::string& name) {
  std::vector<std::string> names;
  for (const FilterInput& input : filter.inputs) names.push_back(input.name);
  for (const FilterImport& import : filter.imports) names.push_back(import.name);
  for (const std::string& given : {filter.overview, filter.light})
    if (!given.empty()) names.push_back(given);
  std::sort(names.begin(), names.end());
  if (const auto twice = std::adjacent_find(names.begin(), names.end()); twice != names.end())
    throw InputError("{}: two inputs are called \"{}\"; rename one", name, *twice);
}

void addNotes(Filter& filter) {
  for (const FilterInput& input : filter.inputs)
    if (input.type == FilterInputType::Audio || input.type == FilterInputType::AudioSpectrum)
      filter.notes.push_back(fmt::format("\"{}\" listens to sound, and is given silence", input.name));
  for (const FilterPass& pass : filter.passes)
    if (pass.persistent)
      filter.notes.push_back(
          fmt::format("\"{}\" remembers frames before this one, and begins with black at each", pass.target));
  if (!filter.takesImage) filter.notes.emplace_back("it has no inputImage: it covers the frame");
}

void readHeader(Filter& filter, const Json& json, const std::string& name) {
  JsonFields fields(json, name);
  filter.description = fields.text("DESCRIPTION").value_or("");
  filter.credit = fields.text("CREDIT").value_or("");
  if (const Json* categories = fields.find("CATEGORIES"); categories && categories->is_array())
    for (const Json& category : *categories)
      if (category.is_string()) filter.categories.push_back(category.get<std::string>());
  if (fields.find("INPUTS")) {
    int index = 0;
    for (const Json& input : fields.list("INPUTS", "a list of inputs", kMostInputs))
      filter.inputs.push_back(inputFromJson(input, fmt::format("{}: input {}", name, ++index), false));
  }
  const auto picture = std::find_if(filter.inputs.begin(), filter.inputs.end(), [](const FilterInput& input) {
    return input.name == "inputImage" && input.type == FilterInputType::Image;
  });
  filter.takesImage = picture != filter.inputs.end();
  if (filter.takesImage) filter.inputs.erase(picture);
  if (fields.find("PASSES")) {
    int index = 0;
    for (const Json& pass : fields.list("PASSES", "a list of passes", kMostPasses))
      filter.passes.push_back(passFromJson(pass, fmt::format("{}: pass {}", name, index++)));
  }
  if (filter.passes.empty()) filter.passes.emplace_back();
  readPersistentBuffers(filter, fields);
  readImports(filter, fields);
  readOwnKey(filter, fields);
}

}  // namespace

Filter filterFromText(const std::string& text, const fs::path& file) {
  const std::string name = file.string();
  const FilterHeader header = headerOf(text, name);
  Filter filter;
  filter.file = file;
  filter.name = file.stem().string();
  readHeader(filter, header.json, name);
  checkNames(filter, name);
  checkExpressions(filter, name);
  addNotes(filter);
  filter.source = text.substr(header.end + 2);
  filter.sourceLine = lineOf(text, header.end);
  return filter;
}

Filter readFilter(const fs::path& file) {
  Filter filter = filterFromText(readFile(file, kLargestFilter), file);
  std::error_code ignored;
  for (const char* extension : {".vs", ".VS", ".vert", ".VERT"}) {
    fs::path vertex = file;
    vertex.replace_extension(extension);
    if (fs::is_regular_file(vertex, ignored)) filter.vertexSource = readFile(vertex, kLargestFilter);
  }
  return filter;
}

}  // namespace swaplight
