#include "ui/camera_look/camera_look_actions.h"
#include "ui/desk/desk_actions.h"
#include "ui/edits/edits_actions.h"
#include "ui/grade/grade_actions.h"
#include "ui/mixer/mixer_actions.h"
#include "ui/shadows/shadow_actions.h"
#include "ui/shell/studio_window.h"
#include "ui/tools/picture_tool.h"
#include "ui/viewer/viewer_actions.h"

namespace swaplight {

void StudioWindow::addActions() {
  addFileActions();
  addBrushActions(m_actions,
                  m_context);  // before the viewer's: while the brush is in the hand digits are its opacity
  addToolActions(m_actions, m_context);
  addSelectionActions(m_actions, m_context, m_chooser);
  addShadowActions(m_actions, m_context);
  addEditActions(m_actions, m_context,
                 m_chooser);  // before the lights': F2 is for the list that was clicked last
  addLightActions(m_actions, m_lights, m_chooser);
  addBalanceActions(m_actions, m_lights, m_lamps, m_chooser);
  addViewActions(m_actions, m_context, m_chooser);
  addCompareActions(m_actions, m_context);
  addLookActions(m_actions, m_lights);
  addDeskActions(m_actions, m_lights, m_commandLine, m_cues);
  addCameraLookActions(m_actions, m_context, m_chooser);
  addGradeActions(m_actions, m_context, m_chooser);
  addWindowActions();
}

void StudioWindow::addFileActions() {
  const auto hasDocument = [this] { return m_session.hasDocument(); };
  const auto canExport = [this] { return m_session.set() && !m_exports.busy() && !m_sets.busy(); };
  m_actions.add({"file.new", "New from photographs \u2026", "Ctrl+N",
                 "Start from a folder of photographs: describe the lights, then solve.",
                 [this] { whenSaved([this] { askForPhotographs(); }); }});
  m_actions.add({"file.chart", "Read a colour chart \u2026", "",
                 "Read the light, the camera's matrix or a gel off a photograph of a colour chart.",
                 [this] { askForChart({}); }});
  m_actions.add({"file.open", "Open …", "Ctrl+O", "Open a capture, a solved set or a session.",
                 [this] { askForFile(); }});
  m_actions.add(
      {"file.use_on_set", "Use these versions on another set …", "",
       "Open another set of the same lights (wide, close) with this lighting, gallery and cues: a new "
       "session.",
       [this] { askForOtherSet(); }, [this] { return m_session.set() != nullptr; }});
  m_actions.add({"file.save", "Save", "Ctrl+S", "Save the session.",
                 [this] {
                   if (m_session.file().empty())
                     askForSaveName([] {});
                   else
                     m_session.save();
                 },
                 hasDocument});
  m_actions.add({"file.save_as", "Save as …", "Ctrl+Shift+S", "Save the session under another name.",
                 [this] { askForSaveName([] {}); }, hasDocument});
  m_actions.add({"file.export", "Export …", "Ctrl+E",
                 "Export the relit frame, the lights as layers, beta maps, a look or a report.",
                 [this] { askForExport(); }, canExport});
  m_actions.add({"file.export_beta", "Export beta maps \u2026", "",
                 "Export each light's beta map (its share of every pixel) for an image editor.",
                 [this] { askForExport(ExportKind::Beta); }, canExport});
  m_actions.add({"file.close", "Close", "Ctrl+W", "Close the session.",
                 [this] { whenSaved([this] { m_session.close(); }); }, hasDocument});
  m_actions.add({"file.quit", "Quit", "Ctrl+Q", "Quit Swaplight.", [this] { askToQuit(); }});
  m_actions.add({"edit.undo", "Undo", "Ctrl+Z", "Undo the last step.", [this] { m_editor.undo(); },
                 [this] { return m_editor.inGesture() || m_editor.history().canUndo(); }});
  m_actions.add({"edit.redo", "Redo", "Ctrl+Shift+Z Ctrl+Y", "Redo the step that was undone.",
                 [this] { m_editor.redo(); }, [this] { return m_editor.history().canRedo(); }});
}

}  // namespace swaplight
