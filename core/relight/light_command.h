#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/relight/rig.h"

namespace swaplight {

// A line as people type it at a lighting desk: which lights, then what becomes of them.
//
//   1 thru 3 @ 50          lights by number (their place in the rig, from 1), a level in per cent
//   key + fill @ full      by name, by a group's name, by role where no light is called so
//   all - back 3200K       all but one; any light setting (see applySetting), several of them one after the
//                          other
//   key gel L201 @ -1st    gel, green; levels as 50, 50%, full, out, x2, -1st (see levelFromText)
//   2 mute                 mute, unmute, solo, unsolo, on, off, reset
//   @ 80                   the lights that were named last, or chosen
//
// thru is also written through, > or 1-3; @ also at; - also except. A name with spaces stands in "quotes".

inline constexpr const char* kLightCommandExamples =
    "1 thru 3 @ 50, key + fill @ full, all - back 3200K, key gel L201, 2 mute";

/// What a line makes of a rig.
struct LightCommand {
  std::vector<size_t> lights;  ///< meant by it, in the rig's order
  Rig rig;
  bool changes = false;  ///< the line says more than which lights
};

/// Where the line names no lights it is about `chosen`. Lights that are locked to one that gets a level keep
/// their ratio to it. Throws InputError: a word that is neither a light nor a setting, no lights.
[[nodiscard]] LightCommand lightCommand(const Rig& rig, std::string_view line,
                                        std::span<const size_t> chosen = {});

/// What the last word of an unfinished line can become.
struct LightCommandEnds {
  size_t from = 0;  ///< where that word begins; the line's end where there is none yet
  std::vector<std::string> words;
};
[[nodiscard]] LightCommandEnds lightCommandEnds(const Rig& rig, std::string_view line);

}  // namespace swaplight
