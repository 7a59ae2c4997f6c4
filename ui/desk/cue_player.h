#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "ui/control/lights_context.h"

namespace swaplight {

/// Goes through the gallery as through a cue list: from look to look in their order, each faded in as dimmers
/// would do it. A fade is one step of the history; whoever touches the lights meanwhile ends it where it is.
class CuePlayer {
 public:
  static constexpr float kUsualSeconds = 3;
  static constexpr float kMostSeconds = 3600;

  /// Which look is gone to: "" or "next", "back", a number from 1, or a name; then "in 2" or "in 2.5s" for a
  /// fade time other than the last one, 0 to kMostSeconds. Returns what it does, in words. Throws InputError.
  std::string go(const LightsContext& studio, const std::string& where);
  /// To be called every frame: shows how far the fade is.
  void update(const LightsContext& studio);
  [[nodiscard]] bool fading() const { return m_fade.has_value(); }
  [[nodiscard]] float seconds() const { return m_seconds; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Fade {
    std::string name;
    Rig from, to;
    Rig shown;  ///< what the fade made last
    Clock::time_point began;
    float seconds = 0;
  };
  void show(const LightsContext& studio, float amount);

  std::optional<Fade> m_fade;
  std::string m_last;  ///< the name of the look that was gone to
  float m_seconds = kUsualSeconds;
};

}  // namespace swaplight
