#pragma once

#include "core/session/document_editor.h"
#include "render/picture_screen.h"
#include "ui/actions/action_table.h"
#include "ui/control/color_choice.h"
#include "ui/control/edit_controller.h"
#include "ui/control/session_controller.h"
#include "ui/control/set_controller.h"
#include "ui/control/shadow_controller.h"
#include "ui/control/subject_pictures.h"
#include "ui/jobs/messages.h"
#include "ui/pictures/view_table.h"
#include "ui/state/edits_state.h"
#include "ui/state/look_state.h"
#include "ui/state/mixer_state.h"
#include "ui/state/panel_layout.h"
#include "ui/state/tool.h"
#include "ui/state/view_state.h"
#include "ui/state/viewer_state.h"

namespace swaplight {

/// What the viewer has drawn last: for those who draw over it or ask what is under the mouse.
struct ShownPicture {
  bool valid = false;
  ViewWindow window;  ///< of the pane under the mouse, in pixels of the screen
  float originX = 0;  ///< the pane's corner on the screen
  float originY = 0;
  bool hovered = false;
  uint64_t revision = 0;  ///< of the document that it shows
};

/// What a panel reads, and where its edits go. References to parts that the studio owns.
struct StudioContext {
  DocumentEditor& editor;
  ViewState& view;
  PanelLayout& layout;
  SessionController& session;
  SetController& sets;
  PictureScreen& pictures;
  const ActionTable& actions;
  Messages& messages;
  const Keyboard& keyboard;
  ShownPicture& shown;
  MixerState& mixer;
  Tool& tool;
  ViewerState& viewer;
  SubjectPictures& subjects;
  ViewTable& table;
  LookState& looks;
  EditController& edits;
  EditsState& editing;
  const ColorChoice& colors;
  ShadowController& shadows;

  [[nodiscard]] const Document& document() const { return editor.document(); }
  [[nodiscard]] const OpenSet* set() const { return session.set(); }
};

}  // namespace swaplight
