#pragma once

#include "core/session/swatches.h"
#include "ui/actions/action_table.h"
#include "ui/camera/look_shelf.h"
#include "ui/control/edit_controller.h"
#include "ui/control/light_edit.h"
#include "ui/control/session_controller.h"
#include "ui/jobs/messages.h"
#include "ui/pictures/view_table.h"
#include "ui/state/color_choice.h"
#include "ui/state/look_state.h"
#include "ui/state/mixer_state.h"
#include "ui/state/panel_layout.h"

namespace swaplight {

/// What those read and change who mix the lights: mixer, light, looks, gallery.
struct LightsContext : ChosenLights {
  SessionController& session;
  const EditController& edits;
  Messages& messages;
  const ColorChoice& colors;
  PanelLayout& layout;
  MixerState& mixer;
  Swatches& swatches;
  LookState& looks;
  ViewTable& table;
  const ActionTable& actions;
  LookShelf& shelf;  ///< camera looks

  [[nodiscard]] const OpenSet* set() const { return session.set(); }
  [[nodiscard]] bool hasLights() const { return set() && !document().rig.lights.empty(); }
};

}  // namespace swaplight
