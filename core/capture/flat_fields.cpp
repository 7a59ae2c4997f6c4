#include "core/capture/flat_fields.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/capture/capture_pixels.h"
#include "core/capture/left_out.h"
#include "core/capture/no_such_light.h"
#include "core/file/json_fields.h"
#include "core/image/io/image_io.h"

namespace swaplight {
namespace {

constexpr const char* kFlats = "flats";
constexpr const char* kLens = "vignetting";

/// A surface is even, whatever its grain: blocks farther from a smooth field are a picture of something.
constexpr double kUneven = 0.02;

std::map<std::string, std::string> lampsIn(const Json& object) {
  if (const auto flats = object.find(kFlats); flats != object.end())
    return flats->get<std::map<std::string, std::string>>();
  return {};
}

/// It shows the field that the shots show: one of another size may be another part of it.
void checkSizeOfFlat(const Capture& capture, const std::string& name) {
  const std::filesystem::path file = capture.folder / name;
  const std::filesystem::path shot = capture.folder / capture.shots.front().image;
  const ImageSpec flat = readImageSpec(file), wanted = readImageSpec(shot);
  if (flat.width != wanted.width || flat.height != wanted.height)
    throw InputError("{} is {} x {} pixels, {} is {} x {}. Export all pictures of a capture at one size.",
                     file.string(), flat.width, flat.height, shot.string(), wanted.width, wanted.height);
}

/// In linear light; what was saturated is not a number.
Image flatPicture(const ColorConfig& config, const Capture& capture, const std::string& name) {
  checkSizeOfFlat(capture, name);
  Capture flat;
  flat.folder = capture.folder;
  flat.file = capture.file;
  flat.colorSpace = capture.colorSpace;
  flat.frame = capture.frame;
  flat.dark = capture.dark;
  flat.shots.emplace_back().image = name;
  CapturePixels pixels = loadCapturePixels(config, flat);
  Image image = std::move(pixels.shots.front());
  for (int c = 0; c < 3; ++c)
    for (size_t p = 0; p < image.pixelCount(); ++p)
      if (float& value = image.plane(c)[p]; value >= pixels.clipLevel.front()) value = NAN;
  return image;
}

void warnOfField(const std::string& name, const FieldFit& fit, FlatFields& fields) {
  if (fit.misfit > kUneven)
    fields.warnings.push_back(
        fmt::format("{}: differs by {:.0f} % from a smooth field: it should show nothing but an even grey "
                    "surface",
                    name, 100 * fit.misfit));
}

/// The lamps' fields, every picture read once.
class LampFields {
 public:
  LampFields(const ColorConfig& config, const Capture& capture, FlatFields& fields)
      : m_config(config), m_capture(capture), m_fields(fields) {}

  const SmoothField& of(const std::string& name) {
    if (const auto known = m_known.find(name); known != m_known.end()) return known->second;
    const std::string where = (m_capture.folder / name).string();
    Image flat = flatPicture(m_config, m_capture, name);
    if (m_fields.lens) m_fields.lens->takeFrom(flat);  // it has coloured this picture, too
    const FieldFit fit = colorFieldOf(flat, where);
    warnOfField(where, fit, m_fields);
    return m_known.emplace(name, fit.field).first->second;
  }

 private:
  const ColorConfig& m_config;
  const Capture& m_capture;
  FlatFields& m_fields;
  std::map<std::string, SmoothField> m_known;
};

std::map<std::string, std::string> checkedLamps(const Json& json, const std::string& where,
                                                const std::vector<Light>& lights) {
  JsonFields flats(json, where);
  std::vector<std::string> names;
  for (const Light& light : lights) names.push_back(light.name);
  std::map<std::string, std::string> lamps;
  for (const auto& [light, name] : json.items()) {
    const auto path = flats.text(light);
    static_cast<void>(placeOfLight(names, light, where));
    if (!path || path->empty())
      throw InputError("{}: \"{}\" needs the path of a picture of a grey card.", where, light);
    lamps[light] = *path;
  }
  return lamps;
}

}  // namespace

FlatFields FlatFields::within(const PixelRect& part, int width, int height) const {
  FlatFields fields = *this;
  for (auto& shot : fields.lamps)
    for (auto& lamp : shot)
      if (lamp) lamp = lamp->within(part, width, height);
  if (lens) fields.lens = lens->within(part, width, height);
  return fields;
}

FlatNames flatNamesOf(const Capture& capture) {
  FlatNames names;
  const Json& kept = capture.extra.json();
  names.lamps = lampsIn(kept);
  for (size_t k = 0; k < capture.shots.size(); ++k)
    if (auto lamps = lampsIn(capture.shots[k].extra.json()); !lamps.empty()) {
      names.shots.resize(capture.shots.size());
      names.shots[k] = std::move(lamps);
    }
  if (const auto lens = kept.find(kLens); lens != kept.end()) names.lens = lens->get<std::string>();
  return names;
}

Capture withFlats(Capture capture, const std::map<std::string, std::string>& lamps, const std::string& lens) {
  Json kept = capture.extra.json();
  for (const auto& [light, name] : lamps) kept[kFlats][light] = name;
  if (!lamps.empty()) checkedLamps(kept[kFlats], "flats", capture.lights);
  if (!lens.empty()) kept[kLens] = lens;
  capture.extra = std::move(kept);
  return capture;
}

Capture withoutLostFlats(Capture capture, std::vector<Shot> leftOut) {
  const auto there = [&](const std::string& name) { return std::filesystem::exists(capture.folder / name); };
  const auto keepFound = [&](KeptJson& extra) {
    Json kept = extra.json();
    for (const auto& [light, name] : lampsIn(kept))
      if (capture.lightIndex(light) < 0 || !there(name)) kept[kFlats].erase(light);
    if (kept.contains(kFlats) && kept[kFlats].empty()) kept.erase(kFlats);
    if (const auto lens = kept.find(kLens); lens != kept.end() && !there(lens->get<std::string>()))
      kept.erase(lens);
    extra = std::move(kept);
  };
  keepFound(capture.extra);
  for (Shot& shot : capture.shots) keepFound(shot.extra);
  for (Shot& shot : leftOut) keepFound(shot.extra);
  return withLeftOut(std::move(capture), leftOut);
}

Json flatsFromJson(JsonFields& fields, const std::vector<Light>& lights) {
  Json kept = Json::object();
  if (const Json* flats = fields.find(kFlats); flats && !flats->is_null())
    kept[kFlats] = checkedLamps(*flats, fields.where() + ": flats", lights);
  if (const auto lens = fields.text(kLens)) kept[kLens] = *lens;
  return kept;
}

FlatFields loadFlatFields(const ColorConfig& config, const Capture& capture, const Progress& progress) {
  FlatFields fields;
  const FlatNames names = flatNamesOf(capture);
  if (names.empty()) return fields;
  progress.update(0, "reading flat fields");
  if (names.lens) {
    const std::string where = (capture.folder / *names.lens).string();
    const FieldFit fit = levelFieldOf(flatPicture(config, capture, *names.lens), where);
    warnOfField(where, fit, fields);
    fields.lens = fit.field;
  }
  if (names.lamps.empty() && names.shots.empty()) return fields;
  LampFields known(config, capture, fields);
  for (size_t k = 0; k < capture.shots.size(); ++k) {
    std::map<std::string, std::string> lamps = names.lamps;
    if (k < names.shots.size())
      for (const auto& [light, name] : names.shots[k]) lamps[light] = name;
    auto& shot = fields.lamps.emplace_back(capture.lights.size());
    for (const auto& [light, name] : lamps)
      shot[static_cast<size_t>(capture.lightIndex(light))] = known.of(name);
  }
  return fields;
}

}  // namespace swaplight
