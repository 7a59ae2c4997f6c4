#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/relight/rig.h"

namespace swaplight {

/// Lights that change over the frames of a sequence: settings at key frames, and what lies between.
/// What keys of the ambient light stand under, where no light is called so.
inline constexpr const char* kAmbientName = "ambient";

struct RigAnimation {
  /// Linear: evenly from key to key. Smooth: at rest at every key (t^2 (3 - 2t) of the way).
  enum class Between { Linear, Smooth };
  struct Key {
    int frame = 0;
    std::string setting;  ///< over the light's setting in the rig: see applySetting
    bool operator==(const Key&) const = default;
  };
  Between between = Between::Linear;
  /// By name; keys by frame. "ambient", where no light is called so, is the level of the ambient light, whose
  /// settings are levels: x0.5, 50%, -1st, off.
  std::map<std::string, std::vector<Key>> lights;
  bool operator==(const RigAnimation&) const = default;

  [[nodiscard]] bool empty() const { return lights.empty(); }
  /// Adds a key, in the place of one at that frame.
  void add(const std::string& light, Key key);
};

/// The rig at a frame. Between two keys stops and multiplier change evenly (stops in stops); two temperatures
/// with the same gel in mired; other colours as linear light; to and from a light that is off, the other
/// key's light evenly. Before the first and after the last key their settings hold. Throws InputError where a
/// light is not known or a setting is wrong.
[[nodiscard]] Rig rigAt(const Rig& rig, const RigAnimation& animation, int frame);

/// {"between": "linear" or "smooth", "lights": {"key": [{"frame": 1, "setting": "3200K,-1st"} ...]}}, as a
/// rig file and a session hold it under "animation". Throws InputError.
[[nodiscard]] RigAnimation animationFromJson(const Json& json, const std::string& where = "animation");
[[nodiscard]] Json jsonFromAnimation(const RigAnimation& animation);
[[nodiscard]] RigAnimation::Between betweenFromName(const std::string& name);

}  // namespace swaplight
