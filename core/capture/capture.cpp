#include "core/capture/capture.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "core/base/error.h"

namespace swaplight {
namespace {

constexpr std::array<std::pair<Role, const char*>, 7> kRoles = {{{Role::Key, "key"},
                                                                 {Role::Fill, "fill"},
                                                                 {Role::Back, "back"},
                                                                 {Role::Practical, "practical"},
                                                                 {Role::Kicker, "kicker"},
                                                                 {Role::Background, "background"},
                                                                 {Role::Other, "other"}}};

}  // namespace

std::string roleName(Role role) {
  for (const auto& [known, name] : kRoles)
    if (known == role) return name;
  return "other";
}

Role roleFromName(const std::string& name) {
  std::string list;
  for (const auto& [role, known] : kRoles) {
    if (name == known) return role;
    list += (list.empty() ? "" : ", ") + std::string(known);
  }
  throw InputError("the role \"{}\" is not known. Known roles: {}.", name, list);
}

bool isColorName(const std::string& text) {
  const auto letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  return text.size() > 1 && text[0] == '?' && std::all_of(text.begin() + 1, text.end(), letter);
}

int Capture::lightIndex(const std::string& light) const {
  for (size_t i = 0; i < lights.size(); ++i)
    if (lights[i].name == light) return static_cast<int>(i);
  return -1;
}

std::optional<SensorNoise> noiseInFrame(const Capture& capture) {
  std::optional<SensorNoise> noise = capture.noise;
  if (!noise) return noise;
  const double averaged = 1 / (capture.frame.scale * capture.frame.scale);
  noise->fullWell *= averaged;
  noise->read /= std::sqrt(averaged);
  return noise;
}

}  // namespace swaplight
