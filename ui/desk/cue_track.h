#pragma once

#include "ui/control/lights_context.h"
#include "ui/desk/cue_player.h"

namespace swaplight {

/// The cue list on a line of time: each cue's fade as a slope, then how long it stands. The keys at the ends
/// of a slope are dragged: where the fade begins, and where the cue stands. A drag is one step of the
/// history.
class CueTrack {
 public:
  /// At scale 1.
  static constexpr float kHeight = 84;

  /// Fills the width that it is given.
  void draw(const LightsContext& studio, CuePlayer& cues);

 private:
  double m_seconds = 1;  ///< that fit into the width; kept while a key is dragged
  bool m_dragging = false;
};

}  // namespace swaplight
