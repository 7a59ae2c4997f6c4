#pragma once

#include "ui/actions/action_table.h"
#include "ui/control/edit_controller.h"
#include "ui/control/light_edit.h"
#include "ui/control/session_controller.h"
#include "ui/control/shadow_controller.h"
#include "ui/jobs/messages.h"
#include "ui/state/color_choice.h"
#include "ui/state/edits_state.h"
#include "ui/state/panel_layout.h"
#include "ui/state/shown_picture.h"
#include "ui/state/tool.h"

namespace swaplight {

/// What those read and change who edit in the picture: tools, shadows, the list of the edits.
struct EditingContext : ChosenLights {
  SessionController& session;
  Messages& messages;
  const ColorChoice& colors;
  PanelLayout& layout;
  ToolInHand& tool;
  const ShownPicture& shown;
  EditsState& editing;
  EditController& edits;
  ShadowController& shadows;
  const ActionTable& actions;
  const Keyboard& keyboard;

  [[nodiscard]] const OpenSet* set() const { return session.set(); }
  [[nodiscard]] bool hasLights() const { return set() && !document().rig.lights.empty(); }
};

}  // namespace swaplight
