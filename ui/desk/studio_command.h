#pragma once

#include <string>
#include <vector>

#include "ui/control/lights_context.h"
#include "ui/desk/cue_player.h"

namespace swaplight {

/// The one place that turns a command in words into what it does: the command line and scripts come here, as
/// would a desk's faders or messages from a network.
///
///   1 thru 3 @ 50              what becomes of which lights (core/relight/light_command.h)
///   1 thru 3                   chooses them
///   look 2, look moonlight:60% of the gallery by number or name, or one that comes along
///   go, go back, go 3 in 2.5   from cue to cue, faded; without cues from look to look (cue_player.h)
///   back                       the same as go back, where no light is called so
///   cue 3 time 4 follow 2      the cue list (core/cue/cue_command.h)
///   record, record 3           what there is now as a new cue, or in the place of one
///   undo, redo
///   view.fit                   any action by its id
///
/// What it changes is one step of the history. Returns what it did, in words. Throws InputError: what is
/// wrong and what to write.
std::string runStudioCommand(const LightsContext& studio, CuePlayer& cues, const std::string& line);

/// What the last word of an unfinished line can become; `from` is where that word begins.
struct StudioCommandEnds {
  size_t from = 0;
  std::vector<std::string> words;
};
[[nodiscard]] StudioCommandEnds studioCommandEnds(const LightsContext& studio, const std::string& line);

}  // namespace swaplight
