#include "ui/studio_window.h"

namespace swaplight {
namespace {

constexpr double kZoomStep = 1.25;

}  // namespace

void StudioWindow::addActions() {
  addFileActions();
  addLightActions();
  addViewActions();
}

void StudioWindow::addFileActions() {
  const auto hasDocument = [this] { return m_session.hasDocument(); };
  const auto hasSet = [this] { return m_session.set() != nullptr; };
  m_actions.add({"file.open", "Open …", "Ctrl+O", "Open a capture, a solved set or a session.",
                 [this] { whenSaved([this] { askForFile(); }); }});
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
  m_actions.add({"file.export", "Export frame …", "Ctrl+E",
                 "Write the relit picture: EXR scene-linear; PNG, TIFF and JPEG through the view.",
                 [this] { askForExport(); }, hasSet});
  m_actions.add({"file.close", "Close", "Ctrl+W", "Close the session.",
                 [this] { whenSaved([this] { m_session.close(); }); }, hasDocument});
  m_actions.add({"file.quit", "Quit", "Ctrl+Q", "Leave Swaplight.", [this] { askToQuit(); }});
  m_actions.add({"edit.undo", "Undo", "Ctrl+Z", "Take back the last step.", [this] { m_editor.undo(); },
                 [this] { return m_editor.inGesture() || m_editor.history().canUndo(); }});
  m_actions.add({"edit.redo", "Redo", "Ctrl+Shift+Z Ctrl+Y", "Do again what was taken back.",
                 [this] { m_editor.redo(); }, [this] { return m_editor.history().canRedo(); }});
}

void StudioWindow::addViewActions() {
  const auto shown = [this] { return m_shown.valid; };
  m_actions.add({"view.fit", "Fit", "F", "Show the whole picture.", [this] { m_view.showFit(); }, shown,
                 [this] { return m_shown.valid && m_view.fit; }});
  m_actions.add({"view.one_to_one", "Actual pixels", "1", "A pixel of the picture is a pixel of the screen.",
                 [this] { m_view.showAt(m_shown.window, 1); }, shown,
                 [this] { return !m_view.fit && m_view.zoom == 1; }});
  m_actions.add({"view.zoom_in", "Zoom in", "Ctrl++ Ctrl+=", "Larger, about the middle.",
                 [this] { m_view.showAt(m_shown.window, m_shown.window.zoom * kZoomStep); }, shown});
  m_actions.add({"view.zoom_out", "Zoom out", "Ctrl+-", "Smaller, about the middle.",
                 [this] { m_view.showAt(m_shown.window, m_shown.window.zoom / kZoomStep); }, shown});
  m_actions.add({"view.mixer",
                 "Mixer",
                 "",
                 "Show or hide the lights.",
                 [this] { m_layout.mixer = !m_layout.mixer; },
                 {},
                 [this] { return m_layout.mixer; }});
  m_actions.add({"view.hide_panels",
                 "Only the picture",
                 "Tab",
                 "Hide everything but the viewer; again: show it.",
                 [this] { m_layout.hidden = !m_layout.hidden; },
                 {},
                 [this] { return m_layout.hidden; }});
  m_actions.add({"view.full_screen", "Full screen", "F11", "The whole monitor; again: a window.",
                 [this] { m_screen.toggleFullScreen(); }});
}

}  // namespace swaplight
