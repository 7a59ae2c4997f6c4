#include "core/edit/fields/field_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_file.h"

namespace swaplight {

Json jsonFromValue(float value) {
  return jsonNumber(value);
}

Json jsonFromValue(int value) {
  return value;
}

Json jsonFromValue(const std::string& value) {
  return value;
}

Json jsonFromValue(const PointList& points) {
  Json list = Json::array();
  for (const auto& p : points) list.push_back({jsonNumber(p[0]), jsonNumber(p[1])});
  return list;
}

Json jsonFromValue(const Rgb& color) {
  return {jsonNumber(color.r), jsonNumber(color.g), jsonNumber(color.b)};
}

void readValue(JsonFields& fields, const char* key, const Scale& scale, float& value) {
  value = static_cast<float>(fields.number(key, scale.least, scale.most).value_or(value));
}

void readValue(JsonFields& fields, const char* key, const Scale& scale, int& value) {
  value = static_cast<int>(fields.number(key, scale.least, scale.most).value_or(value));
}

void readValue(JsonFields& fields, const char* key, const Scale& /*scale*/, std::string& value) {
  value = fields.text(key).value_or(value);
}

void readValue(JsonFields& fields, const char* key, const Scale& /*scale*/, PointList& points) {
  points.clear();
  for (const Json& p : fields.list(key, "a list of [x, y]"))
    points.push_back(pairFromJson(p, fields.where() + ": " + key));
}

void readValue(JsonFields& fields, const char* key, const Scale& /*scale*/, Rgb& color) {
  const Json* json = fields.find(key);
  if (!json) return;
  const bool rgb = json->is_array() && json->size() == 3 &&
                   std::all_of(json->begin(), json->end(), [](const Json& v) { return v.is_number(); });
  if (!rgb)
    throw InputError("{}: \"{}\" is {}, expected [r, g, b].", fields.where(), key, describeJson(*json));
  color = {(*json)[0].get<float>(), (*json)[1].get<float>(), (*json)[2].get<float>()};
}

size_t choiceFromJson(JsonFields& fields, const char* key, std::span<const char* const> names,
                      size_t otherwise) {
  const std::string name = fields.text(key).value_or(names[otherwise]);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InputError("{}: \"{}\" is \"{}\", expected one of {}.", fields.where(), key, name,
                     fmt::join(names, ", "));
  return static_cast<size_t>(found - names.begin());
}

std::array<float, 2> pairFromJson(const Json& json, const std::string& where) {
  if (!json.is_array() || json.size() != 2 || !json[0].is_number() || !json[1].is_number())
    throw InputError("{}: found {}, expected [x, y].", where, describeJson(json));
  return {json[0].get<float>(), json[1].get<float>()};
}

std::array<int, 2> pixelFromJson(const Json& json, const std::string& where) {
  constexpr float kFarthest = 1e6F;
  const std::array<float, 2> pixel = pairFromJson(json, where);
  for (const float number : pixel)
    if (!(std::abs(number) <= kFarthest))
      throw InputError("{}: is {}, expected a pixel of the picture.", where, json.dump());
  return {static_cast<int>(pixel[0]), static_cast<int>(pixel[1])};
}

}  // namespace swaplight
