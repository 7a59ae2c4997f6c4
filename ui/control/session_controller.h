#pragma once

#include <chrono>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/session/document_editor.h"
#include "core/session/recent_files.h"
#include "core/session/recovery.h"
#include "ui/control/set_controller.h"
#include "ui/jobs/job.h"
#include "ui/jobs/messages.h"
#include "ui/state/color_choice.h"
#include "ui/state/view_state.h"

namespace swaplight {

/// Opens and saves sessions, and sees to it that nothing is lost: which file the document belongs to, the set
/// that it is about, recovery.
class SessionController {
 public:
  SessionController(DocumentEditor& editor, ViewState& view, SetController& sets, Messages& messages,
                    ColorChoice& colors, const std::filesystem::path& stateFolder,
                    std::function<void()> wake);

  /// Sets open in the view of a first start, and what is chosen is not kept: a script makes the same pictures
  /// whoever runs it.
  void rememberNoViews() { m_viewFile.clear(); }
  /// What a set is seen through that comes to a colour configuration without a view of its own. Empty: the
  /// built-in configuration.
  [[nodiscard]] DisplayChoice openingViewIn(const std::filesystem::path& colorConfig);

  /// A capture, a solved set or a session. What goes wrong becomes a message. `solve`: how a capture is
  /// solved; a session says so itself.
  void open(const std::filesystem::path& path, const SolveOptions& solve = {});
  /// The same without solving or reading the pictures, for a file that stopped us before.
  void openWithoutPictures(const std::filesystem::path& path);
  /// What there is now, with its gallery and cues, as a new session on another set (a solved set or a
  /// capture) of the same lights, which are found by their names. What cannot come along is said.
  void useOnSet(const std::filesystem::path& path);
  /// Shows a set that is there already as that of a file.
  void openSet(OpenSet set);
  /// Continues with the work of the studio that died last, which is unsaved from the first moment; its
  /// pictures follow. Its remains are removed once our own place in the recovery folder holds the work.
  void recover();
  void close();

  /// The set that was to be opened is there, but what is open was changed meanwhile: somebody has to say
  /// whether it may take its place (openWaiting), or stays (leaveWaiting).
  [[nodiscard]] bool setWaits() const { return m_waiting.has_value(); }
  void openWaiting();
  void leaveWaiting();

  /// Saves what is there now in a thread; `then` is called once it is in the file. Where it fails a message
  /// says why, and `then` is not called.
  void saveAs(const std::filesystem::path& file, std::function<void()> then = {});
  void save(std::function<void()> then = {}) { saveAs(m_file, std::move(then)); }
  [[nodiscard]] bool saving() const { return m_saving.running(); }
  /// Calls `then` once what is being saved is in its file; not where that fails.
  void afterSaving(const std::function<void()>& then);

  /// The studio is told to end at once: what is unsaved is saved for recovery, and offered at the next start.
  void leaveForRecovery();

  /// To be called often: takes what threads have finished, saves for recovery.
  void update();

  /// Shows the open set with edits from now on.
  void showEdited(std::shared_ptr<LiveSet> edited) { m_set->live = std::move(edited); }
  /// The edits have added or removed lights: to everybody it is another set.
  void lightsChanged() { ++m_setRevision; }

  /// The set that is open, or nullptr.
  [[nodiscard]] const OpenSet* set() const { return m_set ? &*m_set : nullptr; }
  /// Counts up with every set; for those who cache what they make of it.
  [[nodiscard]] uint64_t setRevision() const { return m_setRevision; }
  /// Counts up with every document that is opened or closed.
  [[nodiscard]] uint64_t opened() const { return m_opened; }
  /// The session's file; empty while there is none.
  [[nodiscard]] const std::filesystem::path& file() const { return m_file; }
  /// Something is open, with or without its pictures.
  [[nodiscard]] bool hasDocument() const { return !m_editor.document().source.empty(); }
  /// What the window's title says.
  [[nodiscard]] std::string title() const;
  /// Sets open in this view from now on.
  void rememberView(const DisplayChoice& choice);
  [[nodiscard]] const RecentFiles& recent() const { return m_recent; }
  /// What died studios have left and nobody has decided about.
  [[nodiscard]] const std::vector<Recovered>& recovered() const { return m_recovered; }
  void discardRecoveredFiles();

 private:
  /// What becomes the document once its pictures are there.
  struct Pending {
    Session session;
    std::filesystem::path file;
    bool unsaved = false;   ///< it is in no file of the person's yet
    bool isOpen = false;    ///< the document is there, and waits for its pictures only
    uint64_t replaced = 0;  ///< the revision of the document whose place it takes
  };
  [[nodiscard]] Pending pendingFor(const std::filesystem::path& path);
  void begin(Pending pending);
  void takeSet();
  /// Makes the pending document the one that is open.
  void adoptPending(OpenSet set);
  /// A set was not to be had: what was there stays.
  void notTaken();
  /// Brings the set into the document's working space.
  void followWorkingSpace();
  void adopt(Pending pending, std::optional<OpenSet> set);
  /// Says where the display's view is not to be had.
  void checkDisplay(Document& document);
  void warnOfDarkness();
  void autosave();
  [[nodiscard]] Session currentSession() const;
  /// What is being saved, or waits until something else has been.
  struct Saving {
    Session session;
    std::filesystem::path file;
    uint64_t step = 0;
    uint64_t opened = 0;
    std::function<void()> then;
  };
  void beginSaving(Saving saving);
  void takeSaved();

  DocumentEditor& m_editor;
  ViewState& m_view;
  SetController& m_sets;
  Messages& m_messages;
  ColorChoice& m_colors;

  std::optional<OpenSet> m_set;
  uint64_t m_setRevision = 0;
  std::optional<Pending> m_pending;
  std::optional<OpenSet> m_waiting;  ///< of the pending document
  std::filesystem::path m_file;
  Session m_base;  ///< what was read with the document and travels back into the file

  std::function<void()> m_wake;
  uint64_t m_opened = 0;  ///< counts documents
  Job<bool> m_saving;
  Saving m_beingSaved;
  std::deque<Saving> m_toBeSaved;

  std::filesystem::path m_viewFile;
  RecentFiles m_recent;
  std::vector<Recovered> m_recovered;
  std::unique_ptr<RecoverySlot> m_slot;
  Job<bool> m_autosave;
  std::chrono::steady_clock::time_point m_lastAutosave;
  uint64_t m_autosaved = 0;       ///< the document's revision in the recovery file
  std::string m_autosaveProblem;  ///< what was said last
};

}  // namespace swaplight
