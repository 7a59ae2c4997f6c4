#include "ui/shell/studio_window.h"

#include <imgui.h>

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
#include "ui/grade/grade_actions.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::milliseconds kTick{250};  // between looks at timers while nothing happens

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
      m_seen([&window] { window.wake(); }),
      m_thumbnails([&window] { window.wake(); }),
      m_shelf([this]() -> FilterLibrary& { return m_seen.library(); }, favouriteLooksFile()),
      m_edits({m_editor, m_session, m_subjects, *m_pictures, m_messages}, [&window] { window.wake(); }),
      m_shadows({{m_editor, m_view}, m_session, m_edits, m_editing.shadow, m_messages},
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
      m_lights{{m_editor, m_view}, m_session, m_edits, m_messages, m_colors, m_layout, m_mixer,
               m_swatches,         m_looks,   m_table, m_actions,  m_shelf},
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
  m_window.releaseWaitingThreads();
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
  askAboutWaitingSet();
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
  if (!set) return;
  if (!m_layout.cameraLook) return m_thumbnails.releaseOtherSet(set->live);
  SeenRequest frame = frameRequest(m_colors.config(), set->live, m_edits.revision(), m_editor.document(),
                                   m_editor.document().rig);
  frame.look = {};
  m_thumbnails.update(frame, !m_editor.inGesture() && !busy(), m_seen.library());
}

double StudioWindow::restSeconds() const {
  const std::chrono::duration<double> step = m_editing.selection.marching ? kMarchStep : kTick;
  return step.count();
}

}  // namespace swaplight
