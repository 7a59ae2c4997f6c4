#pragma once

#include "ui/actions/action_table.h"
#include "ui/control/lights_context.h"
#include "ui/desk/command_line.h"
#include "ui/desk/cue_player.h"

namespace swaplight {

/// The action that leads the keyboard to the command line; GO and BACK through the gallery.
void addDeskActions(ActionTable& actions, const LightsContext& studio, CommandLine& line, CuePlayer& cues);

}  // namespace swaplight
