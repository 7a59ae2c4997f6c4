#pragma once

#include <map>
#include <string>

#include "ui/control/lights_context.h"
#include "ui/desk/cue_player.h"
#include "ui/desk/cue_track.h"

namespace swaplight {

/// The cue list as a desk shows it: number, version, fade and follow, which cue stands and which is next; GO,
/// BACK and Record; below it the same on a line of time.
class CuePanel {
 public:
  static constexpr float kWidth = 336;  ///< at scale 1

  void draw(const LightsContext& studio, CuePlayer& cues);

 private:
  void drawButtons(const LightsContext& studio, const CuePlayer& cues);
  void drawList(const LightsContext& studio, CuePlayer& cues);
  void drawCue(const LightsContext& studio, CuePlayer& cues, const Cue& cue);
  /// A number of seconds to type into; what was typed goes behind `words` in a line about the cue.
  void drawSeconds(const LightsContext& studio, const Cue& cue, const char* words, const std::string& shown,
                   const char* tip);

  /// What stands in fields that are typed into. Two in the frame in which a click leads from one to another.
  std::map<std::string, std::string> m_typed;
  CueTrack m_track;
};

}  // namespace swaplight
