#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/color/rgb.h"
#include "core/json.h"

namespace swaplight {

/// How a person gave a light its colour. Kept as given, so that 3200 K stays 3200 K.
struct LightColor {
  enum class Kind { White, Hex, LinearRgb, Hsv, Kelvin };
  Kind kind = Kind::White;
  Rgb value{1, 1, 1};   ///< Hex: sRGB-encoded 0..1; LinearRgb: linear >= 0; Hsv: degrees/360, 0..1, 0..1
  float kelvin = 6500;  ///< Kelvin: 1000..25000
  std::string gel;      ///< a filter over any kind: maker's letter and number, as L201; empty: none
  float green = 0;      ///< -1..+1: minus/plus green over any kind, 1 = a full gel
  bool operator==(const LightColor&) const = default;
};

/// One light's part in a new lighting.
struct LightSetting {
  std::string light;  ///< name
  LightColor color;
  float stops = 0;       ///< 0 = as captured
  float multiplier = 1;  ///< >= 0, on top of the stops
  bool on = true;
  bool solo = false;
  bool mute = false;
  bool operator==(const LightSetting&) const = default;
};

/// A lighting of the set: what the mixer edits, what relight applies.
struct Rig {
  std::vector<LightSetting> lights;  ///< in the capture's order
  float ambient = 1;                 ///< multiplier of what no light explains, >= 0
  bool operator==(const Rig&) const = default;
};

/// Every light on, at unit white.
[[nodiscard]] Rig defaultRig(std::span<const std::string> lightNames);

/// The linear Rec.709 factor on a light's contribution: colour x 2^stops x multiplier, or 0 where it is off.
/// Does not look at solo.
[[nodiscard]] Rgb lightFactor(const LightSetting& setting);

/// The factors of all lights, solo and mute applied: where any light is solo, the others are off.
[[nodiscard]] std::vector<Rgb> rigFactors(const Rig& rig);

/// Parses a SETTING (FORMATS 4) such as "3200K,+1st" onto a setting. Throws InputError that quotes the part
/// that is wrong and lists what would be right.
void applySetting(LightSetting& setting, const std::string& text);

[[nodiscard]] Json jsonFromRig(const Rig& rig);
[[nodiscard]] Rig rigFromJson(const Json& json);

}  // namespace swaplight
