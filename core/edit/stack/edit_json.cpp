#include <algorithm>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/capture/light_name.h"
#include "core/edit/fields/field_json.h"
#include "core/edit/operations/operation_json.h"
#include "core/edit/stack/edit.h"
#include "core/file/json_fields.h"
#include "core/file/json_file.h"
#include "core/normals/lamp_place_json.h"

namespace swaplight {
namespace {

constexpr size_t kMostEdits = 4096;
constexpr size_t kMostMarks = 1024;  // of a light
constexpr double kMostPixels = 1e6;  // of a side of a picture

std::vector<std::string> readNames(JsonFields& fields, const char* key) {
  std::vector<std::string> names;
  if (const Json* list = fields.find(key)) {
    const bool texts = list->is_array() &&
                       std::all_of(list->begin(), list->end(), [](const Json& v) { return v.is_string(); });
    if (!texts)
      throw InputError("{}: \"{}\" is {}, expected a list of names.", fields.where(), key,
                       describeJson(*list));
    names = list->get<std::vector<std::string>>();
  }
  return names;
}

std::map<std::string, float> readThresholds(JsonFields& fields) {
  std::map<std::string, float> thresholds;
  const Json* json = fields.find("shadow_thresholds");
  if (!json) return thresholds;
  if (!json->is_object())
    throw InputError("{}: \"shadow_thresholds\" is {}, expected numbers by light.", fields.where(),
                     describeJson(*json));
  for (const auto& [light, value] : json->items()) {
    if (!value.is_number() || !(value.get<float>() > 0 && value.get<float>() < 1))
      throw InputError("{}: the shadow threshold of \"{}\" is {}, expected a number between 0 and 1.",
                       fields.where(), light, value.dump());
    thresholds[light] = value.get<float>();
  }
  return thresholds;
}

ShadowMark readMark(const Json& json, const std::string& where) {
  JsonFields fields(json, where);
  const std::string is = fields.text("is").value_or("");
  if (is != "shadow" && is != "lit")
    throw InputError("{}: \"is\" is \"{}\", expected shadow or lit.", where, is);
  const Json* at = fields.find("at");
  if (!at) throw InputError("{}: has no \"at\", the pixel [x, y] that it is about.", where);
  const auto pixel = pairFromJson(*at, where + ": at");
  for (const double number : pixel)
    if (!(number >= 0 && number < kMostPixels))
      throw InputError("{}: \"at\" is {}, expected a pixel of the picture.", where, at->dump());
  return {is == "lit" ? ShadowMark::Kind::Lit : ShadowMark::Kind::Shadow, static_cast<int>(pixel[0]),
          static_cast<int>(pixel[1])};
}

ShadowMarksByLight readMarks(JsonFields& fields) {
  ShadowMarksByLight all;
  const Json* json = fields.find("shadow_marks");
  if (!json) return all;
  if (!json->is_object())
    throw InputError("{}: \"shadow_marks\" is {}, expected lists of marks by light.", fields.where(),
                     describeJson(*json));
  JsonFields lights(*json, fields.where() + ": shadow_marks");
  for (const auto& [light, value] : json->items())
    for (const Json& mark : lights.list(light, "a list of marks", kMostMarks)) {
      ShadowMarks& marks = all[light];
      marks.push_back(readMark(
          mark, fields.where() + ": shadow mark " + std::to_string(marks.size() + 1) + " of " + light));
    }
  return all;
}

}  // namespace

Json jsonFromEditStack(const EditStack& stack) {
  Json edits = Json::array();
  for (const auto& edit : stack.edits) {
    Json& json = edits.emplace_back(Json::object());
    json["name"] = edit->name;
    json["on"] = edit->on;
    json["opacity"] = jsonNumber(edit->opacity);
    json["lights"] = edit->lights;
    json["meaning"] = edit->energy == EnergyMode::Redistribute ? "share" : "add";
    writeOperation(edit->operation, json);
    json["mask"] = jsonFromMask(edit->mask);
  }
  Json json = {{"new_lights", stack.newLights}, {"edits", std::move(edits)}};
  for (const auto& [light, threshold] : stack.shadowThresholds)
    json["shadow_thresholds"][light] = jsonNumber(threshold);
  for (const auto& [light, marks] : stack.shadowMarks)
    for (const ShadowMark& mark : marks)
      json["shadow_marks"][light].push_back({{"is", wordFor(mark.is)}, {"at", {mark.x, mark.y}}});
  if (!stack.lampPlaces.empty()) json["lamp_places"] = jsonFromLampPlaces(stack.lampPlaces);
  return json;
}

EditStack editStackFromJson(const Json& json, int width, int height, const std::string& where,
                            std::vector<std::string>* warnings) {
  EditStack stack;
  stack.width = width;
  stack.height = height;
  JsonFields fields(json, where);
  for (const char* key : {"format", "version"}) static_cast<void>(fields.find(key));  // of a file of edits
  stack.newLights = readNames(fields, "new_lights");
  checkLightNames(stack.newLights, where + ": new_lights");
  stack.shadowThresholds = readThresholds(fields);
  stack.shadowMarks = readMarks(fields);
  if (const Json* places = fields.find("lamp_places"))
    stack.lampPlaces = lampPlacesFromJson(*places, where + ": lamp_places");
  for (const Json& item : fields.list("edits", "a list of edits", kMostEdits)) {
    JsonFields one(item, where + ": edit " + std::to_string(stack.edits.size() + 1));
    Edit edit;
    edit.name = one.text("name").value_or("");
    edit.on = one.boolean("on").value_or(true);
    edit.opacity = static_cast<float>(one.number("opacity", 0, 1).value_or(1));
    edit.lights = readNames(one, "lights");
    const std::string meaning = one.text("meaning").value_or("share");
    if (meaning != "share" && meaning != "add")
      throw InputError("{}: the meaning is \"{}\", expected share or add.", one.where(), meaning);
    edit.energy = meaning == "add" ? EnergyMode::Add : EnergyMode::Redistribute;
    edit.operation = readOperation(one);
    if (const Json* mask = one.find("mask"))
      edit.mask = maskFromJson(*mask, width, height, one.where(), warnings);
    if (warnings) one.warnOfUnknown(*warnings);
    stack.append(std::move(edit));
  }
  if (warnings) fields.warnOfUnknown(*warnings);
  return stack;
}

}  // namespace swaplight
