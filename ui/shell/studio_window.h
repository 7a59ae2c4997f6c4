#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "ui/chart/chart_dialog.h"
#include "ui/control/export_controller.h"
#include "ui/control/lights_context.h"
#include "ui/control/viewer_context.h"
#include "ui/desk/command_line.h"
#include "ui/desk/cue_panel.h"
#include "ui/desk/cue_player.h"
#include "ui/dialogs/capture_wizard.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/picture_keeper.h"
#include "ui/dialogs/start_page.h"
#include "ui/dialogs/tour.h"
#include "ui/kit/command_palette.h"
#include "ui/kit/file_chooser.h"
#include "ui/kit/keys_window.h"
#include "ui/mixer/gallery_panel.h"
#include "ui/mixer/lamp_reader.h"
#include "ui/scopes/scopes_panel.h"
#include "ui/shell/panel_info.h"
#include "ui/shell/studio.h"
#include "ui/state/window_memory.h"
#include "ui/window/window.h"

namespace swaplight {

/// The studio in a window: owns its parts, draws them around each other.
class StudioWindow {
 public:
  StudioWindow(Window& window, const StudioOptions& options);
  ~StudioWindow();
  StudioWindow(const StudioWindow&) = delete;
  StudioWindow& operator=(const StudioWindow&) = delete;

  /// Draws one frame.
  void frame();
  /// What goes on between frames: threads, recovery, dropped files.
  void update();

  /// Opens a capture, a solved set or a session; a folder of photographs is brought in.
  void open(const std::filesystem::path& path);
  /// For how long nothing has to be done if nothing happens, in seconds.
  [[nodiscard]] double restSeconds() const;

  /// Shows the wizard for a folder of photographs, whether or not there is a capture in it.
  void bringIn(const std::filesystem::path& folder) { m_wizard.start(m_colors.config(), folder); }
  /// Something is being read, solved, guessed, looked for, saved or exported.
  [[nodiscard]] bool busy() const {
    return m_sets.busy() || m_wizard.busy() || m_edits.busy() || m_shadows.busy() || m_session.saving() ||
           m_chart.busy() || m_exports.busy() || m_lamps.busy() || m_seen.busy() || m_gallery.busy();
  }

  /// Ends the studio, after asking what to do with unsaved work.
  void askToQuit();
  /// Ends it without asking.
  void quit() { m_done = true; }
  /// Ends it at once; what is unsaved is offered at the next start.
  void leave();
  [[nodiscard]] bool done() const { return m_done; }
  void exportFrame(const std::filesystem::path& file);
  void exportAs(const ExportRequest& request);
  [[nodiscard]] Window& window() { return m_window; }
  [[nodiscard]] ViewerContext& context() { return m_context; }
  [[nodiscard]] const LightsContext& lights() const { return m_lights; }
  [[nodiscard]] CuePlayer& cues() { return m_cues; }
  [[nodiscard]] const Messages& messages() const { return m_messages; }

 private:
  void addActions();
  void addFileActions();
  void addWindowActions();
  [[nodiscard]] std::vector<PanelInfo> allPanels();
  void drawPanels();
  [[nodiscard]] std::vector<const PanelInfo*> sidePanels(float width);
  void drawViewer(ImVec2 size);
  /// Does it at once, or after the person has decided about unsaved work.
  void whenSaved(const std::function<void()>& then, const std::function<void()>& stay = {});
  /// Asks whether what was opened may take the place of what was changed while it was being read.
  void askAboutWaitingSet();
  void askForFile();
  void askForOtherSet();
  void useOnSet(const std::filesystem::path& file);
  void askForPhotographs();
  void askForChart(const CaptureWizard::ChartQuestion& question);
  void askForSaveName(const std::function<void()>& then);
  void askForExport(std::optional<ExportKind> kind = {});
  void askForExportName();
  void drawDialogs();
  void keepLayout();
  void keepWindow() const;
  void startTour();
  void drawThumbnails();
  void resetForNewSet();
  void drawMainWindow();
  void drawOverlays();
  void drawTour();
  void markEchoes();
  void markStates();
  /// Runs the actions whose keys were pressed, or closes what is on top.
  void hearKeys();
  bool closeTop();
  /// The list of edits is about to close one that was chosen before.
  [[nodiscard]] bool listMoves() const { return m_editing.settling && m_layout.edits && !m_layout.hidden; }
  /// One bit for each dialog that is open or about to be.
  [[nodiscard]] unsigned openDialogs() const;

  Window& m_window;
  std::filesystem::path m_layoutFile;

  DocumentEditor m_editor;
  ViewState m_view;
  PanelLayout m_layout;
  PanelLayout m_layoutOnDisk;
  WindowMemory m_place;  ///< as it was at the start
  bool m_sizeGiven;
  Messages m_messages;
  ColorChoice m_colors;
  SetController m_sets;
  SessionController m_session;
  Swatches m_swatches;
  std::unique_ptr<ViewportRenderer> m_pictures;
  uint64_t m_setShown = 0;
  std::weak_ptr<const SolvedSet> m_originalShown;  ///< as solved
  ExportController m_exports;
  ActionTable m_actions;
  ShownPicture m_shown;
  MixerState m_mixer;
  ToolInHand m_tool = nullptr;
  ViewerState m_viewer;
  SubjectPictures m_subjects;
  LookPreview m_seen;
  LookThumbnails m_thumbnails;
  CameraLookState m_cameraLook;
  LookShelf m_shelf;
  ViewTable m_table;
  LookState m_looks;
  EditController m_edits;
  EditsState m_editing;
  ShadowController m_shadows;
  ScopesPanel m_scopes;
  GalleryPanel m_gallery;
  CommandLine m_commandLine;
  CuePlayer m_cues;
  CuePanel m_cuePanel;
  ViewerContext m_context;
  LightsContext m_lights;
  LampReader m_lamps;
  PictureKeeper m_keeper;
  StartPage m_start;
  std::vector<PanelInfo> m_panels;
  std::vector<const PanelInfo*> m_sides;      ///< open at the sides, in the order of their opening
  std::vector<const PanelInfo*> m_sidesLeft;  ///< of them, those that have no room

  FileChooser m_chooser;
  ExportDialog m_export;
  CaptureWizard m_wizard;
  ChartDialog m_chart;
  UnsavedDialog m_unsaved;
  RecoveryDialog m_recovery;
  Tour m_tour;
  std::filesystem::path m_tourSample;  ///< the capture that it opens where nothing is open
  CommandPalette m_palette;
  KeysWindow m_keys;
  bool m_aboutOpen = false;
  bool m_historyOpen = false;
  unsigned m_dialogsShown = 0;
  int m_echoes = 0;
  std::string m_title;
  std::chrono::steady_clock::time_point m_lastFrame;
  bool m_done = false;
};

}  // namespace swaplight
