#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/look/light_ratios.h"
#include "core/relight/rig.h"

namespace swaplight {

struct SavedLook;

/// What a look does to a light by its role.
struct RoleLook {
  enum class Level {
    AsPhotographed,  ///< stops over the light at unit white
    OverKey,         ///< stops over the key light where both reach (three_point.h), colour counted in
    Off,
  };
  Level level = Level::AsPhotographed;
  float stops = 0;
  LightColor color = {};
};

/// A lighting that cinematographers have a name for, said by roles, so that it suits any set.
struct Look {
  std::string name;   ///< "Golden hour"
  std::string words;  ///< what it is, in one line
  RoleLook key, fill, back;
  RoleLook practical;  ///< lamps in the picture
  RoleLook others;     ///< lights of any other role
  float ambient = 1;
  std::optional<RoleLook> background = {};  ///< lights of the background; without: as the others
};

/// High key, low key, Rembrandt, silhouette, day for night, cool morning, golden hour, moonlight, candle,
/// neon. Lighting ratios are those of textbooks (2:1 high key, 4:1 Rembrandt, 16:1 low key); what has no
/// number there is chosen by eye on the samples.
[[nodiscard]] const std::vector<Look>& presetLooks();

/// By its name, whatever its case and with spaces, dashes or underscores. Throws InputError that lists the
/// names.
[[nodiscard]] const Look& findLook(const std::string& name);
/// The same where it is none of `saved`, which are listed too.
[[nodiscard]] const Look& findLook(const std::string& name, const std::vector<SavedLook>& saved);

/// The rig under a look: colour, dimmer and switch of every light. Throws InputError where no light has the
/// role key.
[[nodiscard]] Rig applyLook(Rig rig, const Look& look, const LightRatios& ratios);

/// Whether a rig leaves the set dark: every light off, or five stops and more below how it was photographed.
[[nodiscard]] bool leavesDark(const Rig& rig);

/// "golden-hour:0.6" or "golden hour:60%" as a name and an amount 0..1 (without one: 1). Throws InputError.
struct LookRequest {
  std::string name;
  float amount = 1;
};
[[nodiscard]] LookRequest lookRequestFromText(const std::string& text);

/// Whether two names are the same but for case, spaces, dashes and underscores.
[[nodiscard]] bool sameLookName(const std::string& a, const std::string& b);

}  // namespace swaplight
