#include "core/capture/no_such_light.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace swaplight {

InputError noSuchLight(const std::string& where, const std::string& name,
                       const std::vector<std::string>& lights) {
  return InputError("{}{}there is no light \"{}\"; the lights are {}", where, where.empty() ? "" : ": ", name,
                    fmt::join(lights, ", "));
}

size_t placeOfLight(const std::vector<std::string>& lights, const std::string& name,
                    const std::string& where) {
  const auto found = std::find(lights.begin(), lights.end(), name);
  if (found == lights.end()) throw noSuchLight(where, name, lights);
  return static_cast<size_t>(found - lights.begin());
}

size_t placeOfLight(const Capture& capture, const std::string& name, const std::string& where) {
  std::vector<std::string> names;
  for (const Light& light : capture.lights) names.push_back(light.name);
  return placeOfLight(names, name, where);
}

}  // namespace swaplight
