#include "ui/studio_window.h"

#include <imgui.h>

#include <algorithm>

#include "core/session/open_source.h"
#include "core/session/user_folders.h"
#include "ui/icons.h"
#include "ui/layout_probe.h"
#include "ui/menu_bar.h"
#include "ui/mixer_panel.h"
#include "ui/status_bar.h"
#include "ui/theme.h"
#include "ui/viewer_panel.h"
#include "ui/welcome_panel.h"
#include "ui/widgets.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr float kToolbarWidth = 46;
constexpr float kSplitter = 4;

std::vector<fs::path> findSamples(const fs::path& folder) {
  std::vector<fs::path> samples;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (fs::exists(entry.path() / "capture.json", error)) samples.push_back(entry.path() / "capture.json");
  std::sort(samples.begin(), samples.end());
  return samples;
}

}  // namespace

StudioWindow::StudioWindow(Screen& screen, const StudioOptions& options)
    : m_screen(screen),
      m_layoutFile(stateFolder() / "panels.json"),
      m_samples(findSamples(options.samplesFolder)),
      m_layout(readPanelLayout(m_layoutFile)),
      m_layoutOnDisk(m_layout),
      m_sets([&screen] { screen.wake(); }),
      m_session(m_editor, m_view, m_sets, m_messages, stateFolder()),
      m_pictures(makePictureScreen(options.engine, ColorConfig::current())),
      m_exports([&screen] { screen.wake(); }),
      m_subjects([&screen] { screen.wake(); }),
      m_context{m_editor,    m_view,    m_layout,   m_session,           m_sets,
                *m_pictures, m_actions, m_messages, m_screen.keyboard(), m_shown,
                m_mixer,     m_tool,    m_viewer,   m_subjects,          m_table} {
  addActions();
}

StudioWindow::~StudioWindow() {
  if (m_layout != m_layoutOnDisk) writePanelLayout(m_layout, m_layoutFile);
}

void StudioWindow::whenSaved(const std::function<void()>& then) {
  m_editor.commit();
  if (m_editor.saved() || !m_session.hasDocument()) {
    then();
    return;
  }
  const std::string name = m_session.file().empty() ? "This session" : m_session.file().filename().string();
  const auto save = [this, then] {
    if (m_session.file().empty())
      askForSaveName(then);
    else if (m_session.save())
      then();
  };
  m_unsaved.ask({name, save, then});
  m_screen.requestFrames();
}

void StudioWindow::askToQuit() {
  m_screen.refuseClose();
  if (!m_unsaved.isOpen()) whenSaved([this] { m_done = true; });
}

void StudioWindow::askForFile() {
  m_chooser.ask({"Open a capture, a solved set or a session",
                 "Open",
                 {".json", ".exr", ".swaplight"},
                 false,
                 "",
                 m_session.hasDocument() ? m_editor.document().source.parent_path() : fs::path(),
                 [this](const fs::path& file) { m_session.open(file); }});
}

void StudioWindow::askForSaveName(const std::function<void()>& then) {
  const fs::path& source = m_editor.document().source;
  const fs::path stem = source.filename() == "capture.json" ? source.parent_path().filename() : source.stem();
  m_chooser.ask({"Save the session",
                 "Save",
                 {".swaplight"},
                 true,
                 stem.string() + ".swaplight",
                 m_session.file().empty() ? source.parent_path() : m_session.file().parent_path(),
                 [this, then](const fs::path& file) {
                   if (m_session.saveAs(file)) then();
                 }});
}

void StudioWindow::askForExport() {
  m_chooser.ask({"Export the frame: EXR, PNG, TIFF or JPEG",
                 "Export",
                 {".exr", ".png", ".tif", ".tiff", ".jpg", ".jpeg", ".hdr"},
                 true,
                 "frame.exr",
                 m_editor.document().source.parent_path(),
                 [this](const fs::path& file) { exportFrame(file); }});
}

void StudioWindow::exportFrame(const fs::path& file) {
  if (const OpenSet* set = m_session.set()) m_exports.exportFrame(set->solved, m_editor.document(), file);
}

void StudioWindow::update() {
  m_session.update();
  m_exports.update(m_messages);
  m_subjects.update(m_messages);
  if (m_messages.expire()) m_screen.requestFrames();
  for (const fs::path& dropped : m_screen.takeDropped())
    whenSaved([this, dropped] { m_session.open(dropped); });
  if (m_screen.closeAsked()) askToQuit();
  const std::string title = m_session.title();
  if (title != m_title) m_screen.setTitle(title);
  m_title = title;
}

void StudioWindow::drawToolbar() {
  const float side = px(34);
  const auto gap = [] { ImGui::Dummy(ImVec2(0, px(6))); };
  actionButton(m_actions, "file.open", kIconOpen, side);
  actionButton(m_actions, "file.save", kIconSave, side);
  actionButton(m_actions, "file.export", kIconExport, side);
  gap();
  actionButton(m_actions, "edit.undo", kIconUndo, side);
  actionButton(m_actions, "edit.redo", kIconRedo, side);
  gap();
  actionButton(m_actions, "view.fit", kIconFit, side);
  actionButton(m_actions, "view.one_to_one", "1:1", side);
}

void StudioWindow::drawPanels() {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float status = m_layout.hidden ? 0 : ImGui::GetFrameHeight() + px(2);
  const float height = room.y - status;
  const bool hasLights = !m_editor.document().rig.lights.empty();
  const bool mixer = m_layout.mixer && !m_layout.hidden && hasLights;
  const float tools = m_layout.hidden ? 0 : px(kToolbarWidth);
  const float mixerWidth = mixer ? std::min(px(m_layout.mixerWidth), room.x * 0.6F) : 0;
  const float viewerWidth = room.x - tools - mixerWidth - (mixer ? px(kSplitter) : 0);

  // The panels lie side by side without gaps; inside they have the usual ones.
  const ImVec2 spacing = ImGui::GetStyle().ItemSpacing;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  if (tools > 0) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(6), px(8)));
    ImGui::BeginChild("##tools", ImVec2(tools, height), false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(4), px(4)));
    drawToolbar();
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::SameLine();
  }
  ImGui::BeginChild("##viewer", ImVec2(viewerWidth, height), false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, spacing);
  if (m_session.hasDocument() || m_sets.busy())
    drawViewerPanel(m_context);
  else
    drawWelcomePanel(m_context, m_samples);
  ImGui::PopStyleVar();
  ImGui::EndChild();
  if (mixer) {
    ImGui::SameLine();
    splitter("##mixer width", true, px(kSplitter), height, &m_layout.mixerWidth, 320, 900, -1);
    ImGui::SameLine();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(10), px(10)));
    ImGui::BeginChild("##mixer", ImVec2(mixerWidth, height), false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, spacing);
    drawMixerPanel(m_context);
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleVar();
  }
  if (status > 0) {
    ImGui::SetCursorScreenPos(ImVec2(at.x + px(10), at.y + height));
    drawStatusBar(m_context);
  }
  ImGui::PopStyleVar();
  drawProgress(m_context, at.x + tools + viewerWidth / 2, at.y + height / 2);
  drawMessages(m_messages, at.x + tools + px(12), at.y + height - px(12), viewerWidth - px(60));
}

void StudioWindow::frame() {
  if (!ImGui::GetIO().WantTextInput && !m_chooser.isOpen() && !m_unsaved.isOpen())
    m_actions.runKeys(m_screen.keyboard());
  if (m_setShown != m_session.setRevision()) {
    m_subjects.forget();
    m_viewer = {};
  }
  if (m_setShown != m_session.setRevision() || m_subjectsShown != m_subjects.revision()) m_pictures->forget();
  m_setShown = m_session.setRevision();
  m_subjectsShown = m_subjects.revision();
  m_screen.beginFrame();
  ImGui::SetNextWindowPos(ImVec2(0, 0));
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                           ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings |
                           ImGuiWindowFlags_NoScrollWithMouse;
  if (!m_layout.hidden) flags |= ImGuiWindowFlags_MenuBar;
  ImGui::Begin("##studio", nullptr, flags);
  ImGui::PopStyleVar(3);
  if (!m_layout.hidden) drawMenuBar(m_context);
  drawPanels();
  ImGui::End();

  m_chooser.draw();
  m_unsaved.draw();
  m_recovery.draw(m_session);
  // However it was made, a gesture ends when nothing is held any more: one gesture, one step.
  if (m_editor.inGesture() && !ImGui::IsAnyItemActive()) m_editor.commit();
  markState("status", m_sets.busy() ? "busy" : m_session.set() ? "ready" : "empty");
  markState("title", m_title);
  endLayoutFrame();
  m_screen.endFrame();
}

}  // namespace swaplight
