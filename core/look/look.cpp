#include "core/look/look.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "core/look/saved_look.h"
#include "core/look/three_point.h"

namespace swaplight {
namespace {

constexpr float kMostBoost = 8;  ///< stops: beyond, a light that hardly reaches the set would be all noise
constexpr float kMostDimming = -30;
constexpr float kDark = -5;  ///< stops

std::string plainName(const std::string& name) {
  std::string plain;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return plain;
}

const RoleLook& partOf(const Look& look, Role role) {
  switch (role) {
    case Role::Key:
      return look.key;
    case Role::Fill:
      return look.fill;
    case Role::Back:
    case Role::Kicker:
      return look.back;
    case Role::Practical:
      return look.practical;
    case Role::Background:
      return look.background ? *look.background : look.others;
    case Role::Other:
      return look.others;
  }
  return look.others;
}

}  // namespace

bool sameLookName(const std::string& a, const std::string& b) {
  return plainName(a) == plainName(b);
}

const Look& findLook(const std::string& name) {
  return findLook(name, {});
}

const Look& findLook(const std::string& name, const std::vector<SavedLook>& saved) {
  std::vector<std::string> known;
  for (const SavedLook& look : saved) known.push_back(look.name);
  for (const Look& look : presetLooks()) {
    if (sameLookName(look.name, name)) return look;
    known.push_back(look.name);
  }
  throw InputError("there is no look \"{}\"; there are: {}", name, fmt::join(known, ", "));
}

Rig applyLook(Rig rig, const Look& look, const LightRatios& ratios) {
  const std::vector<size_t> keys = lightsOfRole(rig, Role::Key);
  if (keys.empty())
    throw InputError(
        "look {}: no light has the role key, which the others are measured by. Give the lights roles, in the "
        "capture's file or in the studio's three-point panel",
        look.name);
  for (LightSetting& light : rig.lights) {
    const RoleLook& part = partOf(look, light.role);
    light.color = part.color;
    light.stops = part.stops;
    light.multiplier = 1;
    light.on = part.level != RoleLook::Level::Off;
    light.solo = light.mute = false;
  }
  for (LightGroup& group : rig.groups) group = {group.name, 0, true};
  rig.ambient = look.ambient;
  // The key is set: what hangs on it follows.
  const size_t key = keys.front();
  for (size_t i = 0; i < rig.lights.size(); ++i) {
    if (partOf(look, rig.lights[i].role).level != RoleLook::Level::OverKey) continue;
    LightSetting& light = rig.lights[i];
    const float wanted = light.stops;
    light.stops = 0;
    const float now = ratios.stops(i, key) + settingStops(rig, i) - settingStops(rig, key);
    light.stops = std::clamp(wanted - now, kMostDimming, kMostBoost);
  }
  return rig;
}

bool leavesDark(const Rig& rig) {
  for (size_t i = 0; i < rig.lights.size(); ++i)
    if (rig.lights[i].on && settingStops(rig, i) > kDark) return false;
  return true;
}

LookRequest lookRequestFromText(const std::string& text) {
  const size_t colon = text.rfind(':');
  LookRequest request{text.substr(0, colon)};
  if (colon == std::string::npos) return request;
  std::string number = text.substr(colon + 1);
  const bool percent = number.ends_with('%');
  if (percent) number.pop_back();
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), request.amount);
  if (percent) request.amount /= 100;
  const bool whole = error == std::errc() && end == number.data() + number.size();
  if (!whole || !(request.amount >= 0 && request.amount <= 1))
    throw InputError("\"{}\": write an amount from 0 to 1 after the colon, as golden-hour:0.6", text);
  return request;
}

}  // namespace swaplight
