#include "ui/control/session_controller.h"

#include <fmt/format.h>

#include <thread>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/ocio/color_config.h"
#include "core/relight/rig.h"
#include "core/session/broken_recovery.h"
#include "core/session/open_source.h"
#include "core/set/solve_verdict.h"
#include "core/setups/other_set.h"
#include "core/view/seen_exposure.h"
#include "ui/state/view_memory.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::seconds kAutosaveInterval{2};
constexpr uint64_t kNothingAutosaved = ~uint64_t{0};  // no revision: the recovery file has to be looked after

std::string shortName(const fs::path& file) {
  // Every capture's file is called capture.json; its folder says more.
  return file.filename() == "capture.json" ? file.parent_path().filename().string()
                                           : file.filename().string();
}

/// A set whose lights are not told apart looks like one that is, until a light is changed.
void warnOfVerdict(const SolvedSet& set, Messages& messages) {
  if (!set.report) return;
  const SolveVerdict verdict = verdictOf(*set.report);
  if (verdict.word == SolveVerdict::Word::NotApart) messages.warn(verdictLine(verdict));
}

}  // namespace

SessionController::SessionController(DocumentEditor& editor, ViewState& view, SetController& sets,
                                     Messages& messages, ColorChoice& colors, const fs::path& stateFolder,
                                     std::function<void()> wake)
    : m_editor(editor),
      m_view(view),
      m_sets(sets),
      m_messages(messages),
      m_colors(colors),
      m_wake(std::move(wake)),
      m_viewFile(viewMemoryFile(stateFolder)),
      m_recent(stateFolder / "recent.json"),
      m_recovered(findRecovered(stateFolder / "recovery")) {
  try {
    m_slot = std::make_unique<RecoverySlot>(stateFolder / "recovery");
  } catch (const std::exception& error) {
    m_messages.warn(error.what());
  }
  for (const std::string& words : setBrokenAside(stateFolder / "recovery")) m_messages.warn(words);
}

DisplayChoice SessionController::openingViewIn(const fs::path& colorConfig) {
  return openingView(*m_colors.configFor(colorConfig), m_viewFile);
}

void SessionController::rememberView(const DisplayChoice& choice) {
  swaplight::rememberView(*m_colors.config(), choice, m_viewFile);
}

SessionController::Pending SessionController::pendingFor(const fs::path& path) {
  Pending pending;
  if (sourceKind(path) == SourceKind::Session) {
    pending.session = readSession(path);
    pending.file = fs::absolute(path).lexically_normal();
  } else {
    if (!fs::exists(path)) throw InputError("{}: there is no such file", path.string());
    pending.session.document.source = sourceFile(path);
    pending.session.document.display = openingViewIn({});
  }
  return pending;
}

void SessionController::open(const fs::path& path, const SolveOptions& solve) {
  try {
    Pending pending = pendingFor(path);
    if (pending.file.empty()) pending.session.document.solve = solve;
    begin(std::move(pending));
  } catch (const std::exception& error) {
    m_messages.error(error.what());
  }
}

void SessionController::openWithoutPictures(const fs::path& path) {
  try {
    adopt(pendingFor(path), std::nullopt);
  } catch (const std::exception& error) {
    m_messages.error(error.what());
  }
}

void SessionController::useOnSet(const fs::path& path) {
  try {
    m_editor.commit();
    const fs::path source = sourceFile(path);
    if (fs::weakly_canonical(source) == fs::weakly_canonical(m_editor.document().source))
      throw InputError("{}: this set is open already. Choose another one.", source.string());
    OtherSetDocument other =
        documentForSet(m_editor.document(), source, captureOfSource(*m_colors.config(), source));
    Pending pending;
    pending.session.document = std::move(other.document);
    pending.session.warnings = std::move(other.notes);
    pending.unsaved = true;
    begin(std::move(pending));
  } catch (const std::exception& error) {
    m_messages.error(error.what());
  }
}

void SessionController::openSet(OpenSet set) {
  Pending pending;
  pending.session.document.source = set.source;
  pending.session.document.display = openingViewIn({});
  adopt(std::move(pending), std::move(set));
}

void SessionController::recover() {
  if (m_recovered.empty()) return;
  const Recovered recovered = m_recovered.front();
  Pending pending;
  try {
    pending = {readSession(recovered.session), recovered.savedAs, true};
  } catch (const std::exception& error) {
    m_messages.error(setAside(recovered.session, error.what()));
    return discardRecoveredFiles();
  }
  Json unknown = pending.session.unknown.json();
  unknown.erase("recovery_of");
  pending.session.unknown = std::move(unknown);
  pending.session.warnings.clear();
  try {
    if (m_slot) m_slot->save(pending.session, pending.file);
    discardRecoveredFiles();
  } catch (const std::exception& error) {  // a full disk: the remains are the only copy, and stay
    m_messages.warn(error.what());
    m_recovered.erase(m_recovered.begin());
  }
  adopt(std::move(pending), std::nullopt);
  begin({currentSession(), m_file, true, true});
}

void SessionController::begin(Pending pending) {
  m_waiting.reset();
  if (pending.session.document.source.empty()) {
    if (!pending.isOpen) adopt(std::move(pending), std::nullopt);
    return;
  }
  if (m_slot) m_slot->opening(pending.file.empty() ? pending.session.document.source : pending.file);
  const Document& document = pending.session.document;
  // Pictures may be in the colour spaces of its own configuration, while the old document keeps its one.
  m_sets.load(m_colors.configFor(document.colorConfig), document.source, document.solve,
              document.workingSpace);
  pending.replaced = m_editor.revision();
  m_pending = std::move(pending);
}

void SessionController::takeSet() {
  const Taken taken = m_sets.take(m_messages, [this](OpenSet set) {
    if (!m_pending) {
      m_set = std::move(set);
      ++m_setRevision;
    } else if (m_pending->isOpen || m_editor.saved() || m_editor.revision() == m_pending->replaced) {
      adoptPending(std::move(set));
    } else {
      m_waiting = std::move(set);
    }
  });
  if (taken == Taken::Nothing) return;
  if (taken == Taken::Stopped) m_messages.info("Cancelled.");
  if (taken != Taken::Value) notTaken();
  if (m_slot) m_slot->opened();
}

void SessionController::adoptPending(OpenSet set) {
  Pending pending = *std::exchange(m_pending, std::nullopt);
  if (pending.isOpen) pending.session = currentSession();
  adopt(std::move(pending), std::move(set));
}

void SessionController::openWaiting() {
  if (m_waiting) adoptPending(*std::exchange(m_waiting, std::nullopt));
}

void SessionController::leaveWaiting() {
  m_waiting.reset();
  m_pending.reset();
}

void SessionController::notTaken() {
  if (!m_pending && m_set) {
    Document next = m_editor.document();
    next.workingSpace = m_set->original == m_set->found ? "" : m_set->original->colorSpace();
    m_editor.edit("Working space: as before", std::move(next));
  }
  m_pending.reset();
}

void SessionController::followWorkingSpace() {
  if (!m_set || m_pending || m_sets.busy() || m_editor.inGesture()) return;
  const std::string& wanted = m_editor.document().workingSpace;
  if (m_set->original->colorSpace() == (wanted.empty() ? m_set->found->colorSpace() : wanted)) return;
  m_sets.convert(m_colors.config(), *m_set, wanted);
}

void SessionController::adopt(Pending pending, std::optional<OpenSet> set) {
  if (!pending.isOpen) m_messages.forgetErrors();
  Document& document = pending.session.document;
  if (set) {
    const int width = set->original->width(), height = set->original->height();
    document.edits = fitEdits(document.edits, width, height);
    for (SavedLook& look : document.looks)
      if (look.scene) look.scene->edits = fitEdits(look.scene->edits, width, height);
    document.rig = fitRig(document.rig, withNewLights(set->original->capture, document.edits));
    for (const std::string& warning : set->original->capture.warnings) m_messages.warn(warning);
    if (sourceKind(document.source) == SourceKind::Capture) warnOfVerdict(*set->original, m_messages);
  }
  for (const std::string& warning : pending.session.warnings) m_messages.warn(warning);
  m_colors.follow(document.colorConfig, m_messages);
  checkDisplay(document);
  m_editor.reset(document, "Open " + shortName(document.source));
  if (pending.unsaved) m_editor.markUnsaved();
  m_view = viewStateFromJson(pending.session.studio.json());
  ++m_opened;
  m_file = pending.file;
  m_base = std::move(pending.session);
  m_set = std::move(set);
  ++m_setRevision;
  m_autosaved = pending.unsaved ? kNothingAutosaved : m_editor.revision();
  m_recent.add(m_file.empty() ? m_editor.document().source : m_file);
  warnOfDarkness();
}

/// A director who sees a black picture does not know whether it is broken.
void SessionController::warnOfDarkness() {
  constexpr float kDarkStops = 3;
  if (!m_set || m_view.settings.exposureStops != 0) return;
  const Rig& rig = m_editor.document().rig;
  const auto stops = stopsToSee(m_set->pictures().layers(
      {}, rigFactors(*m_colors.config(), rig, m_set->solved().colorSpace()), rig.ambient));
  if (stops && *stops > kDarkStops)
    m_messages.info(
        fmt::format("The picture is {:.0f} stops below white. View, Expose to see (Ctrl+Shift+E), shows "
                    "it brighter here and leaves exports as they are.",
                    *stops));
}

void SessionController::checkDisplay(Document& document) {
  const ColorConfig& config = *m_colors.config();
  const DisplayChoice shown = displayWithin(config, document.display);
  if (shown != document.display)
    m_messages.warn(displayWords(document.display) + " is not in the colour configuration " + config.title() +
                    ": shown through " + displayWords(namedDisplay(config, shown)) + ".");
  try {
    if (!document.display.empty()) config.checkView(shown);
  } catch (const InputError& error) {
    m_messages.error(error.what());
    document.display = {"", "", {}, document.display.grade};
  }
}

void SessionController::close() {
  m_sets.cancel();
  leaveWaiting();
  m_editor.reset({}, "Start");
  m_view = {};
  m_set.reset();
  ++m_setRevision;
  ++m_opened;
  m_file.clear();
  m_base = {};
  if (m_slot) m_slot->forget();
}

Session SessionController::currentSession() const {
  Session session = m_base;
  session.document = m_editor.document();
  session.studio = jsonFromViewState(m_view);
  return session;
}

void SessionController::saveAs(const fs::path& file, std::function<void()> then) {
  m_editor.commit();
  Saving saving{currentSession(), fs::absolute(file).lexically_normal(), m_editor.history().stepId(),
                m_opened, std::move(then)};
  if (m_saving.running())
    m_toBeSaved.push_back(std::move(saving));
  else
    beginSaving(std::move(saving));
}

void SessionController::afterSaving(const std::function<void()>& then) {
  std::function<void()>& last = m_toBeSaved.empty() ? m_beingSaved.then : m_toBeSaved.back().then;
  last = [first = std::move(last), then] {
    if (first) first();
    then();
  };
}

void SessionController::beginSaving(Saving saving) {
  m_beingSaved = std::move(saving);
  m_saving.start(
      [session = m_beingSaved.session, file = m_beingSaved.file](const Progress&) {
        writeSession(session, file);
        return true;
      },
      m_wake);
}

void SessionController::takeSaved() {
  std::function<void()> then;
  const Taken taken = takeOrReport(m_saving, m_messages, "saving", [&](bool) {
    if (m_beingSaved.opened == m_opened) {
      m_file = m_beingSaved.file;
      m_editor.markSaved(m_beingSaved.step);
      m_autosaved = kNothingAutosaved;
    }
    m_recent.add(m_beingSaved.file);
    m_messages.info("Saved " + m_beingSaved.file.filename().string());
    then = std::move(m_beingSaved.then);
  });
  if (taken == Taken::Nothing) return;
  m_beingSaved = {};
  if (!m_toBeSaved.empty()) {
    Saving next = std::move(m_toBeSaved.front());
    m_toBeSaved.pop_front();
    beginSaving(std::move(next));
  }
  if (then) then();
}

void SessionController::update() {
  takeSet();
  followWorkingSpace();
  takeSaved();
  autosave();
}

void SessionController::autosave() {
  if (!m_slot) return;
  try {
    if (m_autosave.take()) m_autosaveProblem.clear();
  } catch (const std::exception& error) {  // tried again, and said once
    m_autosaved = kNothingAutosaved;
    if (m_autosaveProblem != error.what()) m_messages.warn(error.what());
    m_autosaveProblem = error.what();
  }
  const auto now = std::chrono::steady_clock::now();
  if (m_autosave.running() || now - m_lastAutosave < kAutosaveInterval) return;
  if (m_autosaved == m_editor.revision()) return;
  m_lastAutosave = now;
  m_autosaved = m_editor.revision();
  if (m_editor.saved()) {
    m_slot->forget();
    return;
  }
  m_autosave.start(
      [slot = m_slot.get(), session = currentSession(), file = m_file](const Progress&) {
        slot->save(session, file);
        return true;
      },
      [] {});
}

void SessionController::leaveForRecovery() {
  if (!m_slot || m_editor.saved()) return;
  constexpr std::chrono::milliseconds kStep{5};
  while (m_autosave.running()) {  // an older state must not be written over this one
    try {
      if (!m_autosave.take()) std::this_thread::sleep_for(kStep);
    } catch (const std::exception& error) {
      m_messages.warn(error.what());
    }
  }
  m_slot->leave();
  m_slot->save(currentSession(), m_file);
}

void SessionController::discardRecoveredFiles() {
  // Of one studio: nobody has decided about the others.
  if (m_recovered.empty()) return;
  discardRecovered(m_recovered.front());
  m_recovered.erase(m_recovered.begin());
}

std::string SessionController::title() const {
  if (!hasDocument()) return "Swaplight";
  const std::string name = shortName(m_file.empty() ? m_editor.document().source : m_file);
  return name + (m_editor.saved() ? "" : " (edited)") + " – Swaplight";
}

}  // namespace swaplight
