#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/base/kept_json.h"
#include "core/capture/capture_frame.h"
#include "core/color/rgb.h"

namespace swaplight {

class ColorConfig;

/// What a light is for on the set.
enum class Role { Key, Fill, Back, Practical, Kicker, Background, Other };
[[nodiscard]] std::string roleName(Role role);
/// Throws InputError that lists the known roles.
[[nodiscard]] Role roleFromName(const std::string& name);

struct Light {
  std::string name;  ///< [A-Za-z][A-Za-z0-9_]*
  Role role = Role::Other;
  KeptJson extra = {};  ///< keys we do not know, kept
};

struct Shot {
  std::string image;  ///< path, relative to the capture's folder
  /// One linear RGB a light, in the capture's order; {0,0,0} is off, nothing is "unknown: estimate it".
  std::vector<std::optional<Rgb>> lightColors;
  /// What unknown colours are called, one a light: the same name is the same colour, in whatever shot it
  /// stands (a gel that travels). "" for a colour without a name; may be shorter than the lights.
  std::vector<std::string> colorNames;
  float exposureStops = 0;  ///< this shot's exposure over the first one's
  bool crossed = false;     ///< through a polariser across those of the lamps: without the highlights
  KeptJson extra;

  /// "?a", or "" where the light's colour is known or has no name.
  [[nodiscard]] std::string colorName(size_t light) const {
    return light < colorNames.size() && !lightColors[light] ? colorNames[light] : "";
  }
};

/// Whether a text is the name of an unknown colour: a question mark, then letters, digits or _.
[[nodiscard]] bool isColorName(const std::string& text);

/// Sensor noise: variance = signal / fullWell + read^2, in full-scale units (1 = clipping).
struct SensorNoise {
  double read = 0;        ///< >= 0
  double fullWell = 1e9;  ///< > 0
  bool operator==(const SensorNoise&) const = default;
};

/// A set photographed K times while only the colours of its N lights change: `capture.json` (formats.md).
/// Only the description; CapturePixels are its pictures.
struct Capture {
  std::filesystem::path folder;  ///< what its paths are relative to
  std::filesystem::path file;    ///< where it was read from, for messages; may be empty
  std::string name;
  std::string colorSpace = "lin_rec709";  ///< of the image files
  std::vector<Light> lights;
  std::vector<Shot> shots;
  std::optional<std::string> ambient;        ///< picture of the set with every controlled light off
  std::optional<std::string> dark;           ///< picture with the lens capped
  std::optional<SensorNoise> noise;          ///< of the files' pixels
  CaptureFrame frame;                        ///< the part of the pictures that is used, and its size
  std::map<std::string, std::string> truth;  ///< test material: each light's contribution
  KeptJson extra;
  std::vector<std::string> warnings;  ///< unknown keys and the like, in words

  /// What messages call it: its file, or its own name where it was read from none.
  [[nodiscard]] std::string calledName() const { return file.empty() ? name : file.string(); }
  [[nodiscard]] int lightCount() const { return static_cast<int>(lights.size()); }
  [[nodiscard]] int shotCount() const { return static_cast<int>(shots.size()); }
  /// The index of a light by name, or -1.
  [[nodiscard]] int lightIndex(const std::string& name) const;
};

/// The noise of the pictures as they are used: averaging has taken some of it.
[[nodiscard]] std::optional<SensorNoise> noiseInFrame(const Capture& capture);

/// Reads and checks a manifest. Throws InputError: one line that names the file, what is wrong, what to do
/// (JSON errors with line and column). Does not open the pictures. Where "color_space" is missing, it is that
/// of the first shot by the configuration's file rules, else lin_rec709.
[[nodiscard]] Capture readCapture(const ColorConfig& config, const std::filesystem::path& file);
/// The same from JSON that is already parsed, without file rules; `folder` is what its paths are relative to.
[[nodiscard]] Capture captureFromJson(const Json& json, const std::filesystem::path& folder,
                                      const std::filesystem::path& file = {});
[[nodiscard]] Json jsonFromCapture(const Capture& capture);
/// Writes to a temporary name, then renames.
void writeCapture(const Capture& capture, const std::filesystem::path& file);

}  // namespace swaplight
