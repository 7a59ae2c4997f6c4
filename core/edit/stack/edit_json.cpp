#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/edit/stack/edit.h"
#include "core/file/json_fields.h"
#include "core/file/json_file.h"

namespace swaplight {
namespace {

constexpr const char* kOperationNames[] = {"fill", "gain",    "curve",   "invert",
                                           "blur", "sharpen", "picture", "shadow"};
constexpr size_t kMostEdits = 4096;
constexpr const char* kShadowNames[] = {"lighten", "deepen", "soften", "sharpen", "recolor"};

Json pairs(const std::vector<std::array<float, 2>>& points) {
  Json list = Json::array();
  for (const auto& p : points) list.push_back({jsonNumber(p[0]), jsonNumber(p[1])});
  return list;
}

Json fieldsOf(const FillOperation& o) {
  return {{"value", jsonNumber(o.value)}};
}
Json fieldsOf(const GainOperation& o) {
  return {{"gain", jsonNumber(o.gain)}, {"offset", jsonNumber(o.offset)}};
}
Json fieldsOf(const CurveOperation& o) {
  return {{"points", pairs(o.points)}};
}
Json fieldsOf(const InvertOperation&) {
  return Json::object();
}
Json fieldsOf(const BlurOperation& o) {
  return {{"radius", o.radius}};
}
Json fieldsOf(const SharpenOperation& o) {
  return {{"radius", o.radius}, {"amount", jsonNumber(o.amount)}};
}
Json fieldsOf(const PictureOperation& o) {
  return {{"file", o.file}, {"channel", o.channel}};
}
Json fieldsOf(const ShadowOperation& o) {
  return {{"kind", kShadowNames[static_cast<size_t>(o.kind)]},
          {"amount", jsonNumber(o.amount)},
          {"radius", o.radius},
          {"color", {jsonNumber(o.color.r), jsonNumber(o.color.g), jsonNumber(o.color.b)}}};
}

float numberOr(JsonFields& fields, const char* key, float fallback, double low, double high) {
  return static_cast<float>(fields.number(key, low, high).value_or(fallback));
}

CurveOperation readCurve(JsonFields& fields) {
  CurveOperation curve{{}};
  for (const Json& p : fields.list("points", "a list of [x, y]")) {
    const bool pair = p.is_array() && p.size() == 2 && p[0].is_number() && p[1].is_number();
    if (!pair) throw InputError("{}: a point is {}, expected [x, y].", fields.where(), describeJson(p));
    curve.points.push_back({p[0].get<float>(), p[1].get<float>()});
  }
  return curve;
}

ShadowOperation readShadow(JsonFields& fields) {
  ShadowOperation shadow;
  const std::string kind = fields.text("kind").value_or("lighten");
  const auto* found = std::find(std::begin(kShadowNames), std::end(kShadowNames), kind);
  if (found == std::end(kShadowNames))
    throw InputError("{}: the kind is \"{}\", expected one of {}.", fields.where(), kind,
                     fmt::join(kShadowNames, ", "));
  shadow.kind = static_cast<ShadowOperation::Kind>(found - kShadowNames);
  shadow.amount = numberOr(fields, "amount", 1, 0, 1);
  shadow.radius = static_cast<int>(numberOr(fields, "radius", 12, 1, 256));
  if (const Json* color = fields.find("color")) {
    const bool rgb = color->is_array() && color->size() == 3 &&
                     std::all_of(color->begin(), color->end(), [](const Json& v) { return v.is_number(); });
    if (!rgb)
      throw InputError("{}: \"color\" is {}, expected [r, g, b].", fields.where(), describeJson(*color));
    shadow.color = {(*color)[0].get<float>(), (*color)[1].get<float>(), (*color)[2].get<float>()};
  }
  return shadow;
}

Operation readOperation(JsonFields& fields) {
  const std::string name = fields.text("operation").value_or("");
  if (name == "fill") return FillOperation{numberOr(fields, "value", 1, 0, 100)};
  if (name == "gain")
    return GainOperation{numberOr(fields, "gain", 1, 0, 1e4), numberOr(fields, "offset", 0, -100, 100)};
  if (name == "curve") return readCurve(fields);
  if (name == "invert") return InvertOperation{};
  if (name == "blur") return BlurOperation{static_cast<int>(numberOr(fields, "radius", 8, 1, 256))};
  if (name == "sharpen")
    return SharpenOperation{static_cast<int>(numberOr(fields, "radius", 8, 1, 256)),
                            numberOr(fields, "amount", 1, 0, 100)};
  if (name == "picture")
    return PictureOperation{fields.text("file").value_or(""), fields.text("channel").value_or("")};
  if (name == "shadow") return readShadow(fields);
  throw InputError("{}: \"{}\" is no operation, expected one of {}.", fields.where(), name,
                   fmt::join(kOperationNames, ", "));
}

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

}  // namespace

std::string operationName(const Operation& operation) {
  return kOperationNames[operation.index()];
}

Json jsonFromEditStack(const EditStack& stack) {
  Json edits = Json::array();
  for (const auto& edit : stack.edits) {
    Json& json = edits.emplace_back(Json::object());
    json["name"] = edit->name;
    json["on"] = edit->on;
    json["opacity"] = jsonNumber(edit->opacity);
    json["lights"] = edit->lights;
    json["meaning"] = edit->meaning == Meaning::Share ? "share" : "add";
    json["operation"] = operationName(edit->operation);
    json.update(std::visit([](const auto& operation) { return fieldsOf(operation); }, edit->operation));
    json["mask"] = jsonFromMask(edit->mask);
  }
  Json json = {{"new_lights", stack.newLights}, {"edits", std::move(edits)}};
  for (const auto& [light, threshold] : stack.shadowThresholds)
    json["shadow_thresholds"][light] = jsonNumber(threshold);
  return json;
}

EditStack editStackFromJson(const Json& json, int width, int height, const std::string& where) {
  EditStack stack;
  stack.width = width;
  stack.height = height;
  JsonFields fields(json, where);
  stack.newLights = readNames(fields, "new_lights");
  stack.shadowThresholds = readThresholds(fields);
  for (const Json& item : fields.list("edits", "a list of edits", kMostEdits)) {
    JsonFields one(item, where + ": edit " + std::to_string(stack.edits.size() + 1));
    Edit edit;
    edit.name = one.text("name").value_or("");
    edit.on = one.boolean("on").value_or(true);
    edit.opacity = numberOr(one, "opacity", 1, 0, 1);
    edit.lights = readNames(one, "lights");
    const std::string meaning = one.text("meaning").value_or("share");
    if (meaning != "share" && meaning != "add")
      throw InputError("{}: the meaning is \"{}\", expected share or add.", one.where(), meaning);
    edit.meaning = meaning == "add" ? Meaning::Add : Meaning::Share;
    edit.operation = readOperation(one);
    if (const Json* mask = one.find("mask")) edit.mask = maskFromJson(*mask, width, height, one.where());
    stack.append(std::move(edit));
  }
  return stack;
}

}  // namespace swaplight
