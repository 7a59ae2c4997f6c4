#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/capture/capture.h"
#include "core/color/rgb.h"

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

inline constexpr float kMostStops = 30;  ///< of a setting, brighter or darker

/// One light's part in a new lighting.
struct LightSetting {
  std::string light;  ///< name
  LightColor color;
  float stops = 0;       ///< 0 = as captured; -kMostStops..kMostStops
  float multiplier = 1;  ///< >= 0, on top of the stops
  bool on = true;
  bool solo = false;
  bool mute = false;
  Role role = Role::Other;
  bool ratioLock = false;  ///< keeps its ratio to the other locked lights when one of them is dimmed
  std::string label;       ///< what the person calls it; empty: its name
  std::string group;       ///< of Rig::groups; empty: none
  bool operator==(const LightSetting&) const = default;

  [[nodiscard]] const std::string& title() const { return label.empty() ? light : label; }
};

/// A fader over several lights.
struct LightGroup {
  std::string name;
  float stops = 0;
  bool on = true;
  bool operator==(const LightGroup&) const = default;
};

/// A lighting of the set: what the mixer edits, what relight applies.
struct Rig {
  std::vector<LightSetting> lights;  ///< in the capture's order
  std::vector<LightGroup> groups;
  float ambient = 1;  ///< multiplier of what no light explains, >= 0
  bool operator==(const Rig&) const = default;
};

/// Every light on, at unit white.
[[nodiscard]] Rig defaultRig(std::span<const std::string> lightNames);
/// The same for the lights of a capture, with their roles.
[[nodiscard]] Rig defaultRig(const Capture& capture);

/// `rig` for exactly the lights of `capture`, in its order; lights that it does not name stay unit white.
/// Throws InputError, listing the known lights, where it names one that the capture does not have.
[[nodiscard]] Rig rigFor(const Capture& capture, const Rig& rig);

/// The light of this name. Throws InputError that lists the known ones.
[[nodiscard]] LightSetting& findLight(Rig& rig, const std::string& name);

/// The linear Rec.709 colour alone, gel and green included. Whites have luminance 1, less what a gel takes.
[[nodiscard]] Rgb colorFactor(const LightColor& color);

/// The linear Rec.709 factor on a light's contribution: colour x 2^stops x multiplier, or 0 where it is off.
/// Does not look at solo.
[[nodiscard]] Rgb lightFactor(const LightSetting& setting);

/// The factors of all lights, groups, solo and mute applied: where any light is solo, the others are off. A
/// light whose group is not there stands alone.
[[nodiscard]] std::vector<Rgb> rigFactors(const Rig& rig);
/// The same for pictures in the primaries of another scene-linear colour space (a solved set's). Throws
/// InputError where the configuration lacks it.
[[nodiscard]] std::vector<Rgb> rigFactors(const ColorConfig& config, const Rig& rig,
                                          const std::string& colorSpace);

/// A rig as JSON (docs/formats.md): for every light its name, its colour as a SETTING's text (see setting.h),
/// stops, multiplier, on, solo, mute, role and ratio lock.
[[nodiscard]] Json jsonFromRig(const Rig& rig);
/// What is missing is as in a new light. `where` begins the messages. Throws InputError.
/// `warnings`, if there are any: says in them which keys of the rig, its lights and groups are unknown.
[[nodiscard]] Rig rigFromJson(const Json& json, const std::string& where = "rig",
                              std::vector<std::string>* warnings = nullptr);
/// A rig that is a file of its own, so that it serves for many sets. Throws InputError.
[[nodiscard]] Rig readRig(const std::filesystem::path& file);

}  // namespace swaplight
