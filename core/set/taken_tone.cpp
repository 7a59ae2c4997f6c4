#include "core/set/taken_tone.h"

#include "core/base/json.h"
#include "core/file/json_file.h"

namespace swaplight {

Json jsonFromTakenTone(const TakenTone& tone) {
  Json curve = Json::array();
  for (const auto& [value, light] : tone.curve)
    curve.push_back(Json::array({jsonNumber(value), jsonNumber(light)}));
  return {{"exponent", tone.exponent}, {"curve", curve}};
}

TakenTone takenToneFromJson(const Json& json) {
  TakenTone tone;
  if (!json.is_object()) return tone;
  if (json.contains("exponent") && json["exponent"].is_number())
    tone.exponent = json["exponent"].get<double>();
  if (!json.contains("curve") || !json["curve"].is_array()) return tone;
  for (const Json& pair : json["curve"])
    if (pair.is_array() && pair.size() == 2 && pair[0].is_number() && pair[1].is_number())
      tone.curve.push_back({pair[0].get<float>(), pair[1].get<float>()});
  return tone;
}

}  // namespace swaplight
