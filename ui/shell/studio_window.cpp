#include "ui/shell/studio_window.h"

#include <imgui.h>

#include <algorithm>
#include <tuple>

#include "core/diagnosis/program_log.h"
#include "core/file/user_folders.h"
#include "core/filter/favourite_looks.h"
#include "core/image/io/image_io.h"
#include "core/session/open_source.h"
#include "ui/actions/key_file.h"
#include "ui/camera/seen_frame.h"
#include "ui/camera_look/camera_look_actions.h"
#include "ui/control/viewer_request.h"
#include "ui/dialogs/about_box.h"
#include "ui/dialogs/history_panel.h"
#include "ui/grade/grade_actions.h"
#include "ui/kit/echo_key.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/manners.h"
#include "ui/shell/menu_bar.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::milliseconds kTick{250};  // between looks at timers while nothing happens

bool isNoArrow(const KeyPress& press) {
  const std::string& key = press.key;
  return key != "Left" && key != "Right" && key != "Up" && key != "Down";
}

/// A picture that is no solved set; one that is broken is not, and said to be so where it is opened.
bool isPhotograph(const fs::path& path) {
  std::error_code error;
  if (sourceKind(path) != SourceKind::Other || !fs::exists(path, error)) return false;
  try {
    static_cast<void>(readImageSpec(path));
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

StudioWindow::StudioWindow(Window& window, const StudioOptions& options)
    : m_window(window),
      m_layoutFile(stateFolder() / "panels.json"),
      m_layout(readPanelLayout(m_layoutFile)),
      m_layoutOnDisk(m_layout),
      m_place(readWindowMemory(windowMemoryFile())),
      m_sizeGiven(options.sizeGiven),
      m_sets([&window] { window.wake(); }),
      m_session(m_editor, m_view, m_sets, m_messages, m_colors, stateFolder(), [&window] { window.wake(); }),
      m_swatches(stateFolder() / "colors.json"),
      m_pictures(makeViewportRenderer(options.engine, m_colors.config())),
      m_exports([&window] { window.wake(); }),
      m_subjects([&window] { window.wake(); }),
      m_seen(*m_pictures, [&window] { window.wake(); }),
      m_thumbnails([&window] { window.wake(); }),
      m_shelf([this]() -> FilterLibrary& { return m_seen.library(); }, favouriteLooksFile()),
      m_edits({m_editor, m_session, m_subjects, *m_pictures, m_messages}, [&window] { window.wake(); }),
      m_shadows({{m_editor, m_view}, m_session, m_edits, *m_pictures, m_editing.shadow, m_messages},
                [&window] { window.wake(); }),
      m_scopes({{m_editor, m_view},
                m_session,
                m_edits,
                m_layout.scopeOptions,
                m_viewer,
                m_seen,
                m_colors,
                m_table,
                m_messages},
               [&window] { window.wake(); }),
      m_gallery([&window] { window.wake(); }),
      m_context{{{m_editor, m_view},
                 m_session,
                 m_messages,
                 m_colors,
                 m_layout,
                 m_tool,
                 m_shown,
                 m_editing,
                 m_edits,
                 m_shadows,
                 m_actions,
                 m_window.keyboard()},
                m_viewer,
                m_shown,
                *m_pictures,
                m_subjects,
                m_table,
                m_seen,
                m_thumbnails,
                m_cameraLook,
                m_shelf},
      m_lights{{m_editor, m_view}, m_session, m_messages, m_colors,  m_layout, m_mixer,
               m_swatches,         m_looks,   m_table,    m_actions, m_shelf},
      m_lamps([&window] { window.wake(); }),
      m_keeper(stateFolder() / "pictures", [&window] { window.wake(); }),
      m_start(options.samplesFolder, m_keeper.pictures(), [&window] { window.wake(); }),
      m_panels(allPanels()),
      m_export(stateFolder() / "export.json"),
      m_wizard([&window] { window.wake(); }),
      m_chart([&window] { window.wake(); }),
      m_tourSample(options.samplesFolder / "three_point" / "capture.json"),
      m_keys(configFolder() / "keys.txt") {
  m_chooser.beginIn(m_place.folder);
  if (!options.script.empty()) m_session.rememberNoViews();
  addActions();
  try {
    readKeyFile(m_actions, configFolder() / "keys.txt");
  } catch (const std::exception& error) {
    m_messages.warn(error.what());
  }
}

StudioWindow::~StudioWindow() {
  if (m_layout != m_layoutOnDisk) writePanelLayout(m_layout, m_layoutFile);
  keepWindow();
}

// At once, not at the end: a studio that dies has its panels again.
void StudioWindow::keepLayout() {
  if (m_layout == m_layoutOnDisk || ImGui::IsAnyMouseDown()) return;
  writePanelLayout(m_layout, m_layoutFile);
  m_layoutOnDisk = m_layout;
}

// The size that it had before it was maximised is the one to go back to; one that was asked for once is not
// kept.
void StudioWindow::keepWindow() const {
  WindowMemory now = m_place;
  if (const auto place = m_window.place(); place && !m_sizeGiven) {
    now.maximized = place->maximized;
    if (!place->maximized) std::tie(now.width, now.height) = std::pair(place->width, place->height);
  }
  if (!m_chooser.folder().empty()) now.folder = m_chooser.folder();
  if (now != m_place) writeWindowMemory(now, windowMemoryFile());
}

void StudioWindow::startTour() {
  m_layout.mixer = true;
  m_layout.threePoint = m_layout.hidden = false;
  if (!m_session.set()) open(m_tourSample);
  m_tour.start();
}

void StudioWindow::drawTour() {
  const Rig& rig = m_editor.document().rig;
  const bool open = m_session.set() && !rig.lights.empty();
  if (m_tour.draw(open ? rig.lights.front().light : "")) m_window.requestFrames(1);
}

void StudioWindow::whenSaved(const std::function<void()>& then) {
  m_editor.commit();
  if (m_session.saving()) {
    m_session.afterSaving([this, then] { whenSaved(then); });
    return;
  }
  if (m_editor.saved() || !m_session.hasDocument()) {
    then();
    return;
  }
  const std::string name = m_session.file().empty() ? "This session" : m_session.file().filename().string();
  // What is changed while it is being saved is asked about again.
  const auto save = [this, again = [this, then] { whenSaved(then); }] {
    if (m_session.file().empty())
      askForSaveName(again);
    else
      m_session.save(again);
  };
  m_unsaved.ask({name, save, then});
  m_window.requestFrames();
}

void StudioWindow::askToQuit() {
  m_window.refuseClose();
  if (!m_unsaved.isOpen()) whenSaved([this] { m_done = true; });
}

void StudioWindow::askForFile() {
  m_chooser.ask({"Open a capture, a solved set or a session",
                 "Open",
                 {".json", ".exr", ".swaplight"},
                 false,
                 "",
                 m_session.hasDocument() ? m_editor.document().source.parent_path() : fs::path(),
                 [this](const fs::path& file) { whenSaved([this, file] { open(file); }); }});
}

void StudioWindow::askForOtherSet() {
  m_chooser.ask({"Use the versions on another set of these lights",
                 "Use on it",
                 {".json", ".exr"},
                 false,
                 "",
                 m_editor.document().source.parent_path(),
                 [this](const fs::path& file) { m_session.useOnSet(file); }});
}

void StudioWindow::askForPhotographs() {
  FileChooser::Question question;
  question.title = "Choose the folder of photographs";
  question.button = "Use folder";
  question.extensions = photographExtensions();
  question.forFolder = true;
  question.answer = [this](const fs::path& folder) { m_wizard.start(m_colors.config(), folder); };
  m_chooser.ask(std::move(question));
}

void StudioWindow::askForChart(const CaptureWizard::ChartQuestion& asked) {
  FileChooser::Question question;
  question.title = "A photograph of a colour chart (24 patches), lit by one light";
  question.button = "Read chart";
  question.extensions = photographExtensions();
  question.folder = asked.folder;
  question.answer = [this, asked](const fs::path& file) {
    m_chart.start(m_colors.config(), file, asked.colorSpaceOf, asked.use);
  };
  m_chooser.ask(std::move(question));
}

void StudioWindow::open(const fs::path& path) {
  if (sourceKind(path) == SourceKind::Folder) {
    m_wizard.start(m_colors.config(), path);
  } else if (isPhotograph(path)) {
    m_messages.info(path.filename().string() + " is no solved set. These are the pictures of its folder.");
    m_wizard.start(m_colors.config(), fs::absolute(path).parent_path());
  } else {
    m_session.open(path);
  }
}

void StudioWindow::askForSaveName(const std::function<void()>& then) {
  const fs::path& source = m_editor.document().source;
  const fs::path stem = source.filename() == "capture.json" ? source.parent_path().filename() : source.stem();
  m_chooser.ask(
      {"Save the session",
       "Save",
       {".swaplight"},
       true,
       m_session.file().empty() ? stem.string() + ".swaplight" : m_session.file().filename().string(),
       m_session.file().empty() ? source.parent_path() : m_session.file().parent_path(),
       [this, then](const fs::path& file) { m_session.saveAs(file, then); }});
}

void StudioWindow::askForExport(std::optional<ExportKind> kind) {
  const fs::path& source = m_editor.document().source;
  const fs::path& named = m_session.file().empty() ? source : m_session.file();
  m_export.open((named.filename() == "capture.json" ? named.parent_path().filename() : named.stem()).string(),
                named.parent_path(), kind);
}

void StudioWindow::askForExportName() {
  const fs::path file = m_export.file();
  m_chooser.ask({"Export to", "Choose", formatsOf(m_export.choices().kind), true, file.filename().string(),
                 file.parent_path(), [this](const fs::path& chosen) { m_export.setFile(chosen); }});
}

void StudioWindow::leave() {
  try {
    m_session.leaveForRecovery();
  } catch (const std::exception& error) {
    logLine(error.what());
  }
  m_done = true;
}

void StudioWindow::exportFrame(const fs::path& file) {
  ExportRequest request;
  request.file = file;
  exportAs(request);
}

void StudioWindow::exportAs(const ExportRequest& request) {
  const OpenSet* set = m_session.set();
  if (!set) return;
  Document document = m_editor.document();
  document.display = displayWithin(*m_colors.config(), document.display);  // as it is shown
  m_exports.start(m_colors.config(), set->original, document, request);
}

void StudioWindow::update() {
  m_session.update();
  m_exports.update(m_messages);
  m_lamps.update(m_lights);
  m_keeper.update(m_lights);
  m_wizard.update(m_messages);
  m_chart.update(m_messages);
  m_subjects.update(m_messages);
  m_seen.update(m_messages);
  m_gallery.update(m_messages);
  drawThumbnails();
  if (m_messages.expire()) m_window.requestFrames();
  keepLayout();
  if (!m_layout.cameraLook) m_viewer.filterAlone.reset();  // its button is gone
  const bool marches = m_editing.selection.marching;
  if (marches && std::chrono::steady_clock::now() - m_lastFrame >= kMarchStep) m_window.requestFrames(1);
  if (listMoves() || m_cues.fading() || m_cues.waiting()) m_window.requestFrames(1);
  for (const fs::path& dropped : m_window.takeDropped())
    if (!takeDroppedLook(m_context, dropped) && !takeDroppedGrade(m_context, dropped))
      whenSaved([this, dropped] { open(dropped); });
  if (m_window.closeAsked()) askToQuit();
  const std::string title = m_session.title();
  if (title == m_title) return;
  m_window.setTitle(title);
  m_title = title;
  m_window.requestFrames();
}

/// Of what the last frame showed; while nothing is held, and the viewer's own picture is there.
void StudioWindow::drawThumbnails() {
  const OpenSet* set = m_session.set();
  if (!set || !m_layout.cameraLook) return;
  SeenRequest frame = frameRequest(m_colors.config(), set->live, m_edits.revision(), m_editor.document(),
                                   m_editor.document().rig);
  frame.look = {};
  m_thumbnails.update(frame, !m_editor.inGesture() && !busy(), m_seen.library());
}

double StudioWindow::restSeconds() const {
  const std::chrono::duration<double> step = m_editing.selection.marching ? kMarchStep : kTick;
  return step.count();
}

void StudioWindow::drawDialogs() {
  if (m_chart.isOpen()) return m_chart.draw(m_messages, m_chooser);  // one may have asked for it
  m_wizard.draw(
      m_messages,
      {[this](const fs::path& capture, const SolveOptions& solve) { m_session.open(capture, solve); },
       [this](const CaptureWizard::ChartQuestion& question) { askForChart(question); }});
  m_export.draw(
      *m_colors.config(), m_editor.document(),
      {[this](const ExportRequest& request) { exportAs(request); }, [this] { askForExportName(); }});
}

unsigned StudioWindow::openDialogs() const {
  unsigned open = 0;
  for (const bool one : {m_chooser.isOpen(), m_export.isOpen(), m_wizard.isOpen(), m_chart.isOpen(),
                         m_unsaved.isOpen(), m_palette.isOpen(), m_keys.isOpen()})
    open = 2 * open + (one ? 1 : 0);
  return open;
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
  else if (!ImGui::GetIO().WantTextInput && openDialogs() == 0 && !popupOpen())
    m_actions.runKeys(m_window.keyboard());
}

// What was pressed is counted with the next frame: then this one is on the screen.
void StudioWindow::markEchoes() {
  markState("echoes", std::to_string(m_echoes));
  for (const KeyPress& press : m_window.keyboard().presses)
    if (press.key == kEchoKey && !press.repeat) ++m_echoes;
}

void StudioWindow::frame() {
  m_lastFrame = std::chrono::steady_clock::now();
  m_window.nextInput();
  m_editing.selection.marching = false;  // whoever draws its outline says otherwise
  hearKeys();
  m_cues.update(m_lights);
  markEchoes();
  if (m_setShown != m_session.setRevision()) {
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
    m_editing.chosen = -1;
    m_editing.histograms.clear();
  }
  if (m_setShown != m_session.setRevision() || m_subjectsShown != m_subjects.revision()) m_pictures->forget();
  m_setShown = m_session.setRevision();
  m_subjectsShown = m_subjects.revision();
  m_colors.follow(m_editor.document().colorConfig, m_messages);
  m_pictures->setConfig(m_colors.config());
  m_window.beginFrame();
  m_thumbnails.beginFrame();
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

  m_chooser.draw();
  if (!m_chooser.isOpen()) drawDialogs();
  m_unsaved.draw();
  m_recovery.draw(m_session);
  m_palette.draw(m_actions);
  m_keys.draw(m_actions, m_window.keyboard(), m_messages);
  drawAboutBox(m_pictures->words(), *m_colors.config(), &m_aboutOpen);
  drawHistoryPanel(m_editor, &m_historyOpen);
  drawTour();
  // However it was made, a gesture ends when nothing is held any more: one gesture, one step.
  if (m_editor.inGesture() && !ImGui::IsAnyItemActive() && !m_mixer.nudging && !m_cues.fading())
    m_editor.commit();
  markState("status", m_sets.busy() ? "busy" : m_session.set() ? "ready" : "empty");
  markState("title", m_title);
  markState("popups", std::to_string(openPopups()));
  markState("busy", busy() || listMoves() ? "yes" : "no");
  markState("desk.fading", m_cues.fading() ? "yes" : m_cues.waiting() ? "waiting" : "no");
  markState("camera_look.drawn", m_seen.words());
  markState("camera_look.thumbnails", std::to_string(m_thumbnails.pending()));
  markState("colors", m_colors.config()->title());
  if (const OpenSet* set = m_session.set()) markState("working_space", set->original->colorSpace());
  endLayoutFrame();
  // One that was asked for after its place in the frame comes with the next.
  if (const unsigned dialogs = openDialogs(); std::exchange(m_dialogsShown, dialogs) != dialogs)
    m_window.requestFrames();
  m_window.endFrame();
}

}  // namespace swaplight
