#include "core/set/lamp_field.h"

#include "core/base/json.h"
#include "core/file/json_file.h"

namespace swaplight {
namespace {

bool isColor(const Json& json) {
  return json.is_array() && json.size() == 3 && json[0].is_number() && json[1].is_number() &&
         json[2].is_number();
}

}  // namespace

Json jsonFromLampFields(const std::vector<LampField>& fields) {
  Json list = Json::array();
  for (const LampField& field : fields) {
    Json corners = Json::array();
    for (const auto& color : field.corners)
      corners.push_back(
          {jsonNumber(float(color[0])), jsonNumber(float(color[1])), jsonNumber(float(color[2]))});
    list.push_back({{"light", field.light}, {"size", field.size}, {"corners", corners}});
  }
  return list;
}

std::vector<LampField> lampFieldsFromJson(const Json& json) {
  std::vector<LampField> fields;
  if (!json.is_array()) return fields;
  for (const Json& one : json) {
    if (!one.is_object() || !one.contains("light") || !one["light"].is_string()) continue;
    LampField field{one["light"].get<std::string>(), 0, {}};
    if (one.contains("size") && one["size"].is_number()) field.size = one["size"].get<double>();
    if (one.contains("corners") && one["corners"].is_array() && one["corners"].size() == field.corners.size())
      for (size_t j = 0; j < field.corners.size(); ++j)
        if (isColor(one["corners"][j])) field.corners[j] = one["corners"][j].get<std::array<double, 3>>();
    fields.push_back(field);
  }
  return fields;
}

}  // namespace swaplight
