#include "core/normals/lamp_place_json.h"

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/file/json_fields.h"

namespace swaplight {
namespace {

double angle(JsonFields& fields, const char* key, double most) {
  const std::optional<double> degrees = fields.number(key, -most, most);
  if (!degrees)
    throw InputError("{}: has no \"{}\", degrees from {} to {}.", fields.where(), key, -most, most);
  return *degrees;
}

}  // namespace

Json jsonFromLampPlaces(const LampPlaces& places) {
  Json json = Json::object();
  for (const auto& [light, place] : places) {
    Json& one = json[light] = {{"azimuth", place.azimuth}, {"elevation", place.elevation}};
    if (place.distance) one["distance"] = *place.distance;
    if (place.stops) one["stops"] = *place.stops;
  }
  return json;
}

LampPlaces lampPlacesFromJson(const Json& json, const std::string& where) {
  if (!json.is_object()) throw InputError("{} is {}, expected places by light.", where, describeJson(json));
  LampPlaces places;
  for (const auto& [light, value] : json.items()) {
    JsonFields fields(value, where + " of \"" + light + "\"");
    LampPlace& place = places[light];
    place.azimuth = angle(fields, "azimuth", 180);
    place.elevation = angle(fields, "elevation", 90);
    place.distance = fields.number("distance", 0, kFarthestLamp);
    if (place.distance == 0) place.distance.reset();
    place.stops = fields.number("stops", -kMostLampStops, kMostLampStops);
  }
  return places;
}

}  // namespace swaplight
