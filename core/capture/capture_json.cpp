#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/lower_case.h"
#include "core/capture/capture.h"
#include "core/capture/flat_fields.h"
#include "core/capture/left_out.h"
#include "core/capture/light_name.h"
#include "core/capture/lightings.h"
#include "core/capture/response_curve.h"
#include "core/file/json_fields.h"
#include "core/file/json_file.h"
#include "core/image/io/image_format.h"
#include "core/ocio/color_config.h"

namespace swaplight {
namespace {

constexpr const char* kFormat = "swaplight-capture";
constexpr int kVersion = 1;
constexpr const char* kLeftOut = "left_out";
constexpr const char* kLeftOutShot = "left-out shot";
constexpr const char* kPolarisation = "polarisation";
constexpr const char* kCross = "cross";
constexpr const char* kOpen = "open";
constexpr size_t kMostLights = 64;  // far beyond what a solve takes; longer lists only take time
constexpr size_t kMostShots = 4096;
constexpr double kMostLight = 1e6;  // of a channel of a lamp, whose white is 1

/// Keeps what a newer or another program wrote, and says so.
Json keepUnknown(const JsonFields& fields, std::vector<std::string>& warnings) {
  Json unknown = fields.unknown();
  for (const auto& [key, value] : unknown.items())
    warnings.push_back(fmt::format("{}: the unknown key \"{}\" is kept and not used", fields.where(), key));
  return unknown;
}

void checkFormat(JsonFields& fields, std::vector<std::string>& warnings) {
  const auto format = fields.text("format");
  if (!format)
    warnings.push_back(fmt::format("{}: \"format\" is missing, {} assumed", fields.where(), kFormat));
  if (format.value_or(kFormat) != kFormat)
    throw InputError("{}: \"format\" is \"{}\", expected \"{}\".", fields.where(), *format, kFormat);
  const auto version = fields.number("version", 0, 1e9);
  if (!version)
    warnings.push_back(fmt::format("{}: \"version\" is missing, {} assumed", fields.where(), kVersion));
  const double found = version.value_or(kVersion);
  if (found > kVersion)
    throw InputError("{}: is version {} of {}, this program reads up to {}. Use a newer swaplight.",
                     fields.where(), found, kFormat, kVersion);
  if (found < 1) throw InputError("{}: \"version\" is {}, expected {}.", fields.where(), found, kVersion);
}

std::vector<Light> lightsFromJson(JsonFields& fields, std::vector<std::string>& warnings) {
  const Json& list = fields.list("lights", "a list of lights, such as [{\"name\": \"key\"}]", kMostLights);
  if (list.empty())
    throw InputError("{}: has no lights. Name at least one under \"lights\".", fields.where());
  std::vector<Light> lights;
  std::vector<std::string> names;
  for (size_t i = 0; i < list.size(); ++i) {
    JsonFields light(list[i], fmt::format("{}: light {}", fields.where(), i + 1));
    const auto name = light.text("name");
    if (!name) throw InputError("{}: \"name\" is missing.", light.where());
    const std::string role = light.text("role").value_or("other");
    try {
      lights.push_back({*name, roleFromName(role), keepUnknown(light, warnings)});
    } catch (const InputError& error) {
      throw InputError("{}: {}", light.where(), error.what());
    }
    names.push_back(*name);
  }
  checkLightNames(names, fields.where());
  return lights;
}

std::optional<Rgb> colorFromJson(const Json& json, const std::string& where) {
  if (json.is_null() || json.is_string()) return std::nullopt;
  const std::string expected =
      "expected [red, green, blue] in linear light, null for unknown, or a name such as \"?a\" for an "
      "unknown colour that several lights or shots have";
  if (!json.is_array() || json.size() != 3)
    throw InputError("{}: is {}, {}.", where, describeJson(json), expected);
  Rgb color(0);
  for (int c = 0; c < 3; ++c) {
    const Json& part = json[static_cast<size_t>(c)];
    if (!part.is_number()) throw InputError("{}: holds {}, {}.", where, describeJson(part), expected);
    const double value = part.get<double>();
    if (value < 0)
      throw InputError("{}: holds the negative number {}: light cannot be less than none. Give 0 or more.",
                       where, part.dump());
    if (!(value <= kMostLight))
      throw InputError("{}: holds {}, which no lamp gives. Give a number near 0..1.", where, part.dump());
    color[c] = static_cast<float>(value);
  }
  return color;
}

/// The name of an unknown colour; "" where it has none.
std::string colorNameFromJson(const Json& json, const std::string& where) {
  if (!json.is_string() || json == "?" || json == "unknown") return "";
  const auto name = json.get<std::string>();
  if (!isColorName(name))
    throw InputError(
        "{}: is \"{}\", expected [red, green, blue] in linear light, null for unknown, or the name of an "
        "unknown colour: a question mark and letters or digits, such as \"?a\".",
        where, name);
  return name;
}

void readColors(JsonFields& shot, const std::vector<Light>& lights, Shot& result) {
  const Json& list = shot.list("light_colors", "one [red, green, blue] a light");
  if (list.size() != lights.size())
    throw InputError(
        "{}: \"light_colors\" has {} colour{}, the capture has {} light{}. Give one colour a light.",
        shot.where(), list.size(), list.size() == 1 ? "" : "s", lights.size(), lights.size() == 1 ? "" : "s");
  bool anyName = false;
  for (size_t i = 0; i < list.size(); ++i) {
    const std::string where = fmt::format("{}: the colour of {}", shot.where(), lights[i].name);
    result.colorNames.push_back(colorNameFromJson(list[i], where));
    result.lightColors.push_back(colorFromJson(list[i], where));
    anyName = anyName || !result.colorNames.back().empty();
  }
  if (!anyName) result.colorNames.clear();
}

std::string requiredPath(JsonFields& fields, const std::string& key) {
  const auto path = fields.text(key);
  if (!path) throw InputError("{}: \"{}\" is missing, expected the path of a picture.", fields.where(), key);
  if (path->empty())
    throw InputError("{}: \"{}\" is empty, expected the path of a picture.", fields.where(), key);
  return *path;
}

/// "polarisation".
bool crossedFromJson(JsonFields& shot) {
  const std::string polarisation = shot.text(kPolarisation).value_or(kOpen);
  if (polarisation != kCross && polarisation != kOpen)
    throw InputError("{}: \"{}\" is \"{}\", expected \"{}\" (crossed polarisers) or \"{}\".", shot.where(),
                     kPolarisation, polarisation, kCross, kOpen);
  return polarisation == kCross;
}

/// Those under a key; `noun` is what messages call one of them.
std::vector<Shot> shotsFromJson(JsonFields& fields, const std::string& key, const char* noun,
                                const std::vector<Light>& lights, std::vector<std::string>& warnings) {
  const Json& list = fields.list(key, "a list of shots", kMostShots);
  std::vector<Shot> shots;
  for (size_t k = 0; k < list.size(); ++k) {
    JsonFields fieldsOfShot(list[k], fmt::format("{}: {} {}", fields.where(), noun, k + 1));
    Shot shot;
    shot.image = requiredPath(fieldsOfShot, "image");
    fieldsOfShot.setWhere(fmt::format("{} ({})", fieldsOfShot.where(), shot.image));
    readColors(fieldsOfShot, lights, shot);
    shot.exposureStops = static_cast<float>(
        fieldsOfShot.number("exposure_stops", -kMostExposureStops, kMostExposureStops).value_or(0));
    shot.crossed = crossedFromJson(fieldsOfShot);
    Json kept = flatsFromJson(fieldsOfShot, lights);
    kept.update(keepUnknown(fieldsOfShot, warnings), true);
    shot.extra = std::move(kept);
    shots.push_back(std::move(shot));
  }
  return shots;
}

/// "exposures": those of one bracket, which all others repeat, or one a shot.
void readExposures(JsonFields& fields, std::vector<Shot>& shots) {
  const Json* list = fields.find("exposures");
  if (!list || list->is_null()) return;
  const bool numbers =
      list->is_array() && !list->empty() && std::all_of(list->begin(), list->end(), [](const Json& one) {
        return one.is_number() && std::abs(one.get<double>()) <= kMostExposureStops;
      });
  if (!numbers || shots.size() % list->size() != 0)
    throw InputError(
        "{}: \"exposures\" is {}, expected stops such as [0, -3, 2]: those of one bracket, which all others "
        "repeat, or one for each of the {} shots.",
        fields.where(), describeJson(*list), shots.size());
  for (size_t k = 0; k < shots.size(); ++k) {
    if (shots[k].exposureStops != 0)
      throw InputError("{}: shot {} has \"exposure_stops\", and there are \"exposures\". Give one of both.",
                       fields.where(), k + 1);
    shots[k].exposureStops =
        static_cast<float>((*list)[k % list->size()].get<double>() - (*list)[0].get<double>());
  }
}

std::optional<std::string> optionalPath(JsonFields& fields, const std::string& key) {
  const Json* value = fields.find(key);
  if (!value || value->is_null()) return std::nullopt;
  return requiredPath(fields, key);
}

/// Unknown fields go into extra["noise"].
std::optional<SensorNoise> noiseFromJson(JsonFields& fields, Json& extra,
                                         std::vector<std::string>& warnings) {
  const Json* json = fields.find("noise");
  if (!json || json->is_null()) return std::nullopt;
  JsonFields noise(*json, fields.where() + ": noise");
  SensorNoise result;
  result.read = noise.number("read", 0, 1).value_or(result.read);
  result.fullWell = noise.number("full_well", 1, 1e15).value_or(result.fullWell);
  if (Json rest = keepUnknown(noise, warnings); !rest.empty()) extra["noise"] = std::move(rest);
  return result;
}

std::map<std::string, std::string> truthFromJson(JsonFields& fields) {
  std::map<std::string, std::string> truth;
  const Json* json = fields.find("truth");
  if (!json || json->is_null()) return truth;
  JsonFields paths(*json, fields.where() + ": truth");
  for (const auto& [light, path] : json->items()) truth[light] = requiredPath(paths, light);
  return truth;
}

std::string defaultName(const Capture& capture) {
  const std::filesystem::path folder = std::filesystem::absolute(capture.folder / ".").lexically_normal();
  return folder.has_filename() ? folder.filename().string() : folder.parent_path().filename().string();
}

/// Puts back what was kept.
void addExtra(Json& json, const KeptJson& extra) {
  json.update(extra.json(), true);
}

Json jsonFromColor(const std::optional<Rgb>& color) {
  if (!color) return nullptr;
  return {jsonNumber(color->r), jsonNumber(color->g), jsonNumber(color->b)};
}

/// In the order of the lights.
Json jsonFromTruth(const Capture& capture) {
  Json json = Json::object();
  for (const Light& light : capture.lights)
    if (const auto path = capture.truth.find(light.name); path != capture.truth.end())
      json[light.name] = path->second;
  for (const auto& [light, path] : capture.truth) json[light] = path;
  return json;
}

Json jsonFromShot(const Shot& shot) {
  Json json = {{"image", shot.image}};
  Json& colors = json["light_colors"] = Json::array();
  for (size_t i = 0; i < shot.lightColors.size(); ++i)
    colors.push_back(shot.colorName(i).empty() ? jsonFromColor(shot.lightColors[i])
                                               : Json(shot.colorName(i)));
  if (shot.exposureStops != 0) json["exposure_stops"] = jsonNumber(shot.exposureStops);
  if (shot.crossed) json[kPolarisation] = kCross;
  addExtra(json, shot.extra);
  return json;
}

Json jsonFromShots(const std::vector<Shot>& shots) {
  Json json = Json::array();
  for (const Shot& shot : shots) json.push_back(jsonFromShot(shot));
  return json;
}

/// What the file rules of a colour configuration, where there is one, say about the first shot; else linear
/// Rec.709.
void assumeColorSpace(const ColorConfig* config, Capture& capture, const std::string& where) {
  const std::string byRule = config && !capture.shots.empty()
                                 ? config->colorSpaceOfFile(capture.folder / capture.shots.front().image)
                                 : "";
  if (!byRule.empty()) capture.colorSpace = byRule;
  capture.warnings.push_back(fmt::format("{}: \"color_space\" is missing, {} assumed{}", where,
                                         capture.colorSpace,
                                         byRule.empty() ? "" : " by the colour configuration's file rules"));
}

CaptureFrame frameFromJson(JsonFields& fields) {
  CaptureFrame frame;
  if (const Json* crop = fields.find("crop"); crop && !crop->is_null()) {
    const bool numbers =
        crop->is_array() && crop->size() == 4 && std::all_of(crop->begin(), crop->end(), [](const Json& n) {
          return n.is_number_integer() && n >= 0 && n <= 1 << 16;
        });
    if (!numbers)
      throw InputError("{}: \"crop\" is {}, expected [x, y, width, height] in pixels of the pictures.",
                       fields.where(), crop->dump());
    frame.crop = PixelRect{(*crop)[0], (*crop)[1], (*crop)[2], (*crop)[3]};
    if (frame.crop->empty()) throw InputError("{}: \"crop\" is empty. Crop less.", fields.where());
  }
  frame.scale = fields.number("scale", 0.02, 1).value_or(1);
  return frame;
}

bool samePath(const std::filesystem::path& a, const std::filesystem::path& b) {
  return a.lexically_normal() == b.lexically_normal();
}

/// A photograph under two lightings is a slip of whoever wrote the file; under one it may have been meant.
void checkNoneTwice(const std::vector<Shot>& shots, const std::string& where) {
  for (size_t k = 1; k < shots.size(); ++k)
    for (size_t j = 0; j < k; ++j)
      if (samePath(shots[j].image, shots[k].image) &&
          (shots[j].lightColors != shots[k].lightColors || shots[j].colorNames != shots[k].colorNames))
        throw InputError(
            "{}: shots {} and {} name the same photograph, {}, under different colours. Name the "
            "other photograph.",
            where, j + 1, k + 1, shots[k].image);
}

void checkIsNoShot(const std::optional<std::string>& image, const char* what, const std::vector<Shot>& shots,
                   const std::string& where) {
  for (size_t k = 0; image && k < shots.size(); ++k)
    if (samePath(*image, shots[k].image))
      throw InputError(
          "{}: \"{}\" and shot {} name the same photograph, {}. Name the one without the lights, or leave it "
          "out.",
          where, what, k + 1, shots[k].image);
}

Capture captureBy(const ColorConfig* config, const Json& json, const std::filesystem::path& folder,
                  const std::filesystem::path& file) {
  Capture capture;
  capture.folder = folder;
  capture.file = file;
  JsonFields fields(json, file.empty() ? "the capture" : file.string());
  checkFormat(fields, capture.warnings);
  capture.name = fields.text("name").value_or(defaultName(capture));
  const auto colorSpace = fields.text("color_space");
  if (colorSpace) capture.colorSpace = *colorSpace;
  capture.lights = lightsFromJson(fields, capture.warnings);
  capture.shots = shotsFromJson(fields, "shots", "shot", capture.lights, capture.warnings);
  if (capture.shots.empty())
    throw InputError("{}: has no shots. List at least one under \"shots\".", fields.where());
  // What a solved set says of its photographs nobody can mend.
  if (config) checkNoneTwice(capture.shots, fields.where());
  readExposures(fields, capture.shots);
  if (!colorSpace) assumeColorSpace(config, capture, fields.where());
  capture.ambient = optionalPath(fields, "ambient");
  capture.dark = optionalPath(fields, "dark");
  if (config && capture.ambient && capture.shots.front().exposureStops != 0)
    capture.warnings.push_back(fmt::format(
        "{}: shot 1 has {:g} exposure_stops, which are over the first shot's: the ambient picture is "
        "taken as exposed at 0",
        fields.where(), capture.shots.front().exposureStops));
  if (config) {
    checkIsNoShot(capture.ambient, "ambient", capture.shots, fields.where());
    checkIsNoShot(capture.dark, "dark", capture.shots, fields.where());
  }
  Json noiseExtra = Json::object();
  capture.noise = noiseFromJson(fields, noiseExtra, capture.warnings);
  capture.frame = frameFromJson(fields);
  capture.truth = truthFromJson(fields);
  Json extra = flatsFromJson(fields, capture.lights);
  if (const Json* out = fields.find(kLeftOut); out && !out->is_null())
    extra[kLeftOut] =
        jsonFromShots(shotsFromJson(fields, kLeftOut, kLeftOutShot, capture.lights, capture.warnings));
  extra.update(keepUnknown(fields, capture.warnings), true);
  extra.update(noiseExtra, true);
  capture.extra = std::move(extra);
  return capture;
}

/// By its first bytes, where it is not called .json; false where there is no such file.
bool isPicture(const std::filesystem::path& file) {
  try {
    return lowerExtension(file) != ".json" && !imageFormatOf(file).empty();
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

Capture captureFromJson(const Json& json, const std::filesystem::path& folder,
                        const std::filesystem::path& file) {
  return captureBy(nullptr, json, folder, file);
}

Json jsonFromCapture(const Capture& capture) {
  Json json = {{"format", kFormat},
               {"version", kVersion},
               {"name", capture.name},
               {"color_space", capture.colorSpace}};
  Json& lights = json["lights"] = Json::array();
  for (const Light& light : capture.lights) {
    lights.push_back({{"name", light.name}, {"role", roleName(light.role)}});
    addExtra(lights.back(), light.extra);
  }
  json["shots"] = jsonFromShots(capture.shots);
  if (capture.ambient) json["ambient"] = *capture.ambient;
  if (capture.dark) json["dark"] = *capture.dark;
  if (capture.noise) json["noise"] = {{"read", capture.noise->read}, {"full_well", capture.noise->fullWell}};
  if (const auto& crop = capture.frame.crop) json["crop"] = {crop->x, crop->y, crop->width, crop->height};
  if (capture.frame.scale != 1) json["scale"] = capture.frame.scale;
  if (!capture.truth.empty()) json["truth"] = jsonFromTruth(capture);
  addExtra(json, capture.extra);
  return json;
}

Capture readCapture(const ColorConfig& config, const std::filesystem::path& file) {
  if (isPicture(file))
    throw InputError("{}: is a picture or a solved set; give capture.json or the folder that holds it",
                     file.string());
  Capture capture = captureBy(&config, readJson(file), file.parent_path(), file);
  if (!isResponseFile(capture.colorSpace)) capture.colorSpace = config.knownName(capture.colorSpace);
  return capture;
}

std::vector<Shot> leftOutOf(const Capture& capture) {
  if (!capture.extra.json().contains(kLeftOut)) return {};
  JsonFields fields(capture.extra.json(), "the capture");
  std::vector<std::string> saidBefore;
  return shotsFromJson(fields, kLeftOut, kLeftOutShot, capture.lights, saidBefore);
}

Capture withLeftOut(Capture capture, const std::vector<Shot>& leftOut) {
  Json extra = capture.extra.json();
  extra.erase(kLeftOut);
  if (!leftOut.empty()) extra[kLeftOut] = jsonFromShots(leftOut);
  capture.extra = std::move(extra);
  return capture;
}

void writeCapture(const Capture& capture, const std::filesystem::path& file) {
  writeJson(jsonFromCapture(capture), file);
}

}  // namespace swaplight
