#include "core/solve/model/solve_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/json_integer.h"
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

constexpr std::array<std::pair<Denoise, const char*>, 2> kDenoising = {{
    {Denoise::Off, "off"},
    {Denoise::Guided, "guided"},
}};

// What is taken for a slip of the pen; in units of full scale, and pixels.
constexpr double kMostRead = 1e6;
constexpr double kLeastFullWell = 1e-6, kMostFullWell = 1e30;
constexpr int kWidestRadius = 1000;
constexpr const char* kLeftAsItIs = "left_as_it_is";  // remedies that are not wanted

template <typename Value, size_t count>
std::string nameIn(const std::array<std::pair<Value, const char*>, count>& names, Value wanted) {
  for (const auto& [value, name] : names)
    if (value == wanted) return name;
  return names.front().second;
}

/// `what` begins the message, as "there is no model".
template <typename Value, size_t count>
Value valueIn(const std::array<std::pair<Value, const char*>, count>& names, const std::string& name,
              const char* what) {
  std::string known;
  for (const auto& [value, text] : names) {
    if (name == text) return value;
    known += known.empty() ? text : std::string(", ") + text;
  }
  throw InputError("{} \"{}\". Choose one of: {}", what, name, known);
}

/// Throws InputError where it lies outside, or is not a number.
void checkRange(const char* what, double value, double low, double high) {
  if (!(value >= low && value <= high))
    throw InputError("the {} of a solve is {}, expected {} to {}", what, value, low, high);
}

Json jsonFromChoice(const OpenColorChoice& choice) {
  Json json = Json::object();
  if (choice.oneLamp) json["one_lamp"] = {choice.oneLamp->light, choice.oneLamp->x, choice.oneLamp->y};
  if (choice.grey) json["grey"] = {(*choice.grey)[0], (*choice.grey)[1]};
  if (choice.luminance) json["luminance"] = jsonNumber(*choice.luminance);
  if (choice.position) json["position"] = jsonNumber(*choice.position);
  if (choice.exchanged) json["exchanged"] = true;
  return json;
}

/// A pixel's coordinates from `first` on in a list. Throws InputError.
std::array<int, 2> placeFromJson(const Json& list, size_t first, const std::string& where) {
  const bool known = list.is_array() && list.size() == first + 2;
  const std::optional<int> x = known ? integerOf(list[first]) : std::nullopt;
  const std::optional<int> y = known ? integerOf(list[first + 1]) : std::nullopt;
  if (!x || !y) throw InputError("{}: is {}, expected the x and y of a pixel", where, list.dump());
  return {*x, *y};
}

OpenColorChoice choiceFromJson(const Json& json, const std::string& where) {
  JsonFields fields(json, where);
  OpenColorChoice choice;
  if (const Json* lamp = fields.find("one_lamp")) {
    const auto [x, y] = placeFromJson(*lamp, 1, where + ": one_lamp");
    if (!(*lamp)[0].is_string()) throw InputError("{}: one_lamp begins with no light's name", where);
    choice.oneLamp = {(*lamp)[0].get<std::string>(), x, y};
  }
  if (const Json* grey = fields.find("grey")) choice.grey = placeFromJson(*grey, 0, where + ": grey");
  if (const auto luminance = fields.number("luminance", kLeastGelLuminance, 1))
    choice.luminance = float(*luminance);
  if (const auto position = fields.number("position", 0, 1)) choice.position = float(*position);
  choice.exchanged = fields.boolean("exchanged").value_or(false);
  return choice;
}

}  // namespace

std::string modelName(Model model) {
  return nameIn(kModels, model);
}

Model modelFromName(const std::string& name) {
  return valueIn(kModels, name, "there is no model");
}

std::string denoiseName(Denoise denoise) {
  return nameIn(kDenoising, denoise);
}

Denoise denoiseFromName(const std::string& name) {
  return valueIn(kDenoising, name, "there is no denoising");
}

void SolveOptions::check() const {
  if (noise) checkRange("read noise", noise->read, 0, kMostRead);
  if (noise) checkRange("full well", noise->fullWell, kLeastFullWell, kMostFullWell);
  if (!(colorUncertainty < 0)) checkRange("colour uncertainty", colorUncertainty, 0, 1);
  if (openColor.position) checkRange("position of the open colour", *openColor.position, 0, 1);
  checkRange("radius of denoising", guidedRadius, 1, kWidestRadius);
}

Json jsonFromSolveOptions(const SolveOptions& options) {
  Json json{{"model", modelName(options.model)}};
  if (!options.solver.empty()) json["solver"] = options.solver;
  if (options.noise) json["noise"] = {{"read", options.noise->read}, {"full_well", options.noise->fullWell}};
  if (options.colorUncertainty >= 0) json["color_uncertainty"] = jsonNumber(options.colorUncertainty);
  json["refine_colors"] = options.refineColors;
  json["ambient"] = options.solveAmbient;
  // Older programs know true, and have written false where nothing was asked for.
  const auto writeRemedy = [&](const char* key, Remedy remedy) {
    if (remedy == Remedy::On) json[key] = true;
    if (remedy == Remedy::Off) json[kLeftAsItIs].push_back(key);
  };
  writeRemedy("correct_tone", options.correctTone);
  writeRemedy("align", options.align);
  if (!options.highlights) json["highlights"] = false;
  if (options.field) json["field"] = true;
  if (options.openColor != OpenColorChoice{}) json["open_color"] = jsonFromChoice(options.openColor);
  json["denoise"] = denoiseName(options.denoise);
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
    options.noise = SensorNoise{
        sensor.number("read", 0, kMostRead).value_or(0),
        sensor.number("full_well", kLeastFullWell, kMostFullWell).value_or(SensorNoise{}.fullWell)};
  }
  options.colorUncertainty =
      static_cast<float>(fields.number("color_uncertainty", 0, 1).value_or(options.colorUncertainty));
  options.refineColors = fields.boolean("refine_colors").value_or(options.refineColors);
  options.solveAmbient = fields.boolean("ambient").value_or(options.solveAmbient);
  const Json* left = fields.find(kLeftAsItIs);
  const auto remedy = [&](const char* key) {
    if (fields.boolean(key).value_or(false)) return Remedy::On;
    const bool off = left && left->is_array() && std::find(left->begin(), left->end(), key) != left->end();
    return off ? Remedy::Off : Remedy::Sure;
  };
  options.correctTone = remedy("correct_tone");
  options.align = remedy("align");
  options.highlights = fields.boolean("highlights").value_or(options.highlights);
  options.field = fields.boolean("field").value_or(options.field);
  if (const Json* open = fields.find("open_color"))
    options.openColor = choiceFromJson(*open, where + ": open_color");
  if (const auto denoise = fields.text("denoise")) options.denoise = denoiseFromName(*denoise);
  options.guidedRadius =
      static_cast<int>(fields.number("guided_radius", 1, kWidestRadius).value_or(options.guidedRadius));
  return options;
}

}  // namespace swaplight
