#pragma once

#include <optional>
#include <string>

#include "core/cue/cue_list.h"
#include "ui/control/lights_context.h"

namespace swaplight {

// How the panel and the command line change the cue list. Each is one step of the history.

/// Makes a cue of what there is now (recordCue); then what a line says of it, as "time 4 follow 2". `words`:
/// "", "3", "3 time 4", "cue 3 time 4". Gives its number. Throws InputError, and then nothing has changed.
int recordCueLine(const LightsContext& lights, const std::string& words);

/// What a line says that follows `cue`: see core/cue/cue_command.h. Gives what was done, in words. Throws
/// InputError.
std::string runCueLine(const LightsContext& lights, const std::string& line);

/// The list with one change; `step` names it.
void editCues(const LightsContext& lights, const std::string& step, CueList cues);

}  // namespace swaplight
