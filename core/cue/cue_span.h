#pragma once

#include <vector>

#include "core/cue/cue_list.h"

namespace swaplight {

/// When a cue of a list that is played from its beginning comes and stands, in seconds: the times of
/// CueTimeline before they are rounded to frames. The first cue stands at 0; its own fade has nothing to come
/// from.
struct CueSpan {
  int number = 0;
  double begins = 0;   ///< its fade; where the cue before ends
  double stands = 0;   ///< its fade has ended
  double ends = 0;     ///< the next one begins
  bool waits = false;  ///< for GO: it has no follow, and is counted with the hold
};
/// In the list's order. `holdSeconds`: how long a cue counts that waits for GO; the last one counts with it,
/// too.
[[nodiscard]] std::vector<CueSpan> cueSpans(const CueList& cues, double holdSeconds);

/// The list with a cue's fade beginning at another time: the follow of the cue before changes (and is made,
/// where it waited for GO); all that comes later moves along. The first cue stays. Times are within what a
/// cue can have, rounded to `step` seconds.
[[nodiscard]] CueList withCueBegin(CueList cues, int number, double seconds, double holdSeconds, double step);
/// The list with a cue's fade ending at another time: its fade is longer or shorter, what comes later moves
/// along.
[[nodiscard]] CueList withCueStand(CueList cues, int number, double seconds, double holdSeconds, double step);

}  // namespace swaplight
