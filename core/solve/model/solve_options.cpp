#include "core/solve/model/solve_options.h"

#include <array>
#include <utility>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_fields.h"
#include "core/file/json_file.h"

namespace swaplight {
namespace {

constexpr std::array<std::pair<Model, const char*>, 5> kModels = {{
    {Model::Auto, "auto"},
    {Model::Single, "single"},
    {Model::Lambert, "lambert"},
    {Model::Gloss, "gloss"},
    {Model::Transport, "transport"},
}};

}  // namespace

std::string modelName(Model model) {
  for (const auto& [value, name] : kModels)
    if (value == model) return name;
  return "auto";
}

Model modelFromName(const std::string& name) {
  std::string known;
  for (const auto& [value, text] : kModels) {
    if (name == text) return value;
    known += known.empty() ? text : std::string(", ") + text;
  }
  throw InputError("there is no model \"{}\". Choose one of: {}", name, known);
}

Json jsonFromSolveOptions(const SolveOptions& options) {
  Json json{{"model", modelName(options.model)}};
  if (!options.solver.empty()) json["solver"] = options.solver;
  if (options.noise) json["noise"] = {{"read", options.noise->read}, {"full_well", options.noise->fullWell}};
  if (options.colorUncertainty >= 0) json["color_uncertainty"] = jsonNumber(options.colorUncertainty);
  json["refine_colors"] = options.refineColors;
  json["ambient"] = options.solveAmbient;
  json["align"] = options.align;
  json["denoise"] = options.denoise;
  json["guided_radius"] = options.guidedRadius;
  return json;
}

SolveOptions solveOptionsFromJson(const Json& json, const std::string& where) {
  JsonFields fields(json, where);
  SolveOptions options;
  if (const auto model = fields.text("model")) options.model = modelFromName(*model);
  options.solver = fields.text("solver").value_or("");
  if (const Json* noise = fields.find("noise")) {
    JsonFields sensor(*noise, where + ": noise");
    options.noise = SensorNoise{sensor.number("read", 0, 1e6).value_or(0),
                                sensor.number("full_well", 1e-6, 1e12).value_or(SensorNoise{}.fullWell)};
  }
  options.colorUncertainty =
      static_cast<float>(fields.number("color_uncertainty", 0, 1).value_or(options.colorUncertainty));
  options.refineColors = fields.boolean("refine_colors").value_or(options.refineColors);
  options.solveAmbient = fields.boolean("ambient").value_or(options.solveAmbient);
  options.align = fields.boolean("align").value_or(options.align);
  options.denoise = fields.text("denoise").value_or(options.denoise);
  options.guidedRadius =
      static_cast<int>(fields.number("guided_radius", 1, 1000).value_or(options.guidedRadius));
  return options;
}

}  // namespace swaplight
