#include <imgui.h>

#include <algorithm>

#include "ui/dialogs/about_box.h"
#include "ui/dialogs/history_panel.h"
#include "ui/kit/echo_key.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/manners.h"
#include "ui/shell/menu_bar.h"
#include "ui/shell/studio_window.h"

// A frame of the studio, from what was pressed to what is on the screen.

namespace swaplight {
namespace {

bool isNoArrow(const KeyPress& press) {
  const std::string& key = press.key;
  return key != "Left" && key != "Right" && key != "Up" && key != "Down";
}

/// What no text field takes: keys with Ctrl, but for those that copy and paste.
Keyboard withoutTyping(Keyboard keyboard) {
  std::erase_if(keyboard.presses, [](const KeyPress& press) {
    const std::string& key = press.key;
    return !press.ctrl || key == "A" || key == "C" || key == "V" || key == "X" || key == "Insert";
  });
  keyboard.typed.clear();
  return keyboard;
}

}  // namespace

void StudioWindow::drawTour() {
  const Rig& rig = m_editor.document().rig;
  const bool open = m_session.set() && !rig.lights.empty();
  if (m_tour.draw(open ? rig.lights.front().light : "")) m_window.requestFrames(1);
}

bool StudioWindow::closeTop() {
  if (closeTopList()) return true;
  if (popupOpen()) return false;  // a dialog has a button for it
  if (m_keys.isOpen()) return m_keys.escape();
  if (m_tour.going()) return m_tour.stop(), true;
  if (ImGui::GetIO().WantTextInput) return false;  // the field takes back what was typed
  for (bool* open : {&m_aboutOpen, &m_historyOpen})
    if (std::exchange(*open, false)) return true;
  return false;
}

void StudioWindow::hearKeys() {
  const std::vector<KeyPress>& presses = m_window.keyboard().presses;
  // What a key may do comes after the steps that the wheel has made.
  if (std::exchange(m_mixer.nudging, false) && std::any_of(presses.begin(), presses.end(), isNoArrow))
    m_editor.commit();
  const bool escape = std::any_of(presses.begin(), presses.end(), [](const KeyPress& press) {
    return press.key == "Escape" && !press.repeat;  // held, it closes one thing
  });
  if (escape && closeTop())
    m_window.swallowKeys();
  else if (openDialogs() > 0 || popupOpen())
    return;
  else if (!ImGui::GetIO().WantTextInput)
    m_actions.runKeys(m_window.keyboard());
  else if (m_commandLine.isEmptyAndActive())
    m_actions.runKeys(withoutTyping(m_window.keyboard()));
}

// What was pressed is counted with the next frame: then this one is on the screen.
void StudioWindow::markEchoes() {
  markState("echoes", std::to_string(m_echoes));
  for (const KeyPress& press : m_window.keyboard().presses)
    if (press.key == kEchoKey && !press.repeat) ++m_echoes;
}

// Pictures and panels of the set that was open before are of no use any more.
void StudioWindow::resetForNewSet() {
  if (std::exchange(m_setShown, m_session.setRevision()) == m_session.setRevision()) return;
  m_subjects.forget();
  m_seen.forget();
  m_thumbnails.forget();
  m_shelf.readAgain();
  m_cameraLook = {};
  m_viewer = {};
  m_looks = {};
  m_editing.brush.last.reset();
  m_editing.brush.guide.reset();
  m_editing.selection.outlineKnown = false;
  m_editing.histograms.clear();
  // A light that an edit has added makes no other set: the edit stays chosen.
  const auto original = m_session.set() ? m_session.set()->original : nullptr;
  if (m_originalShown.lock() != original) {
    m_editing.chosen = -1;
    m_editing.lamp = {};
    m_editing.endDrags();  // they hold the document that is gone
  }
  m_originalShown = original;
}

// What fills the window: menus, viewer and panels.
void StudioWindow::drawMainWindow() {
  ImGui::SetNextWindowPos(ImVec2(0, 0));
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                           ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings |
                           ImGuiWindowFlags_NoScrollWithMouse |
                           ImGuiWindowFlags_NoBackground;  // the screen was cleared to its colour
  if (!m_layout.hidden) flags |= ImGuiWindowFlags_MenuBar;
  ImGui::Begin("##studio", nullptr, flags);
  ImGui::PopStyleVar(3);
  if (!m_layout.hidden) drawMenuBar(m_context, m_panels);
  m_edits.beginFrame();
  drawPanels();
  ImGui::End();
}

// What lies over it.
void StudioWindow::drawOverlays() {
  m_chooser.draw();
  if (!m_chooser.isOpen()) drawDialogs();
  m_unsaved.draw();
  m_recovery.draw(m_session);
  m_palette.draw(m_actions);
  m_keys.draw(m_actions, m_window.keyboard(), m_messages);
  drawAboutBox(m_pictures->words(), *m_colors.config(), &m_aboutOpen);
  drawHistoryPanel(m_editor, &m_historyOpen);
  drawTour();
}

// For tests, scripts and whoever else looks at the studio from outside.
void StudioWindow::markStates() {
  markState("status", m_sets.busy() ? "busy" : m_session.set() ? "ready" : "empty");
  markState("title", m_title);
  markState("popups", std::to_string(openPopups()));
  markState("busy", busy() || listMoves() ? "yes" : "no");
  markState("desk.current", m_cues.current() ? cueNumberText(*m_cues.current()) : "");
  markState("desk.fading", m_cues.fading() ? "yes" : m_cues.waiting() ? "waiting" : "no");
  markState("camera_look.drawn", m_seen.words());
  markState("camera_look.thumbnails", std::to_string(m_thumbnails.pending()));
  markState("colors", m_colors.config()->title());
  if (const OpenSet* set = m_session.set()) markState("working_space", set->original->colorSpace());
}

void StudioWindow::frame() {
  m_lastFrame = std::chrono::steady_clock::now();
  m_window.nextInput();
  m_editing.selection.marching = false;  // whoever draws its outline says otherwise
  hearKeys();
  m_cues.update(m_lights);
  markEchoes();
  resetForNewSet();
  m_colors.follow(m_editor.document().colorConfig, m_messages);
  m_pictures->setConfig(m_colors.config());
  m_window.beginFrame();
  m_thumbnails.beginFrame();
  drawMainWindow();
  drawOverlays();
  // However it was made, a gesture ends when nothing is held any more: one gesture, one step.
  if (m_editor.inGesture() && !ImGui::IsAnyItemActive() && !m_mixer.nudging && !m_cues.holdsGesture(m_editor))
    m_editor.commit();
  markStates();
  endLayoutFrame();
  // One that was asked for after its place in the frame comes with the next.
  if (const unsigned dialogs = openDialogs(); std::exchange(m_dialogsShown, dialogs) != dialogs)
    m_window.requestFrames();
  m_window.endFrame();
}

}  // namespace swaplight
