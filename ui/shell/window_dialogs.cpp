#include "core/base/error.h"
#include "core/session/open_source.h"
#include "core/setups/other_set.h"
#include "ui/shell/studio_window.h"

// The studio's dialogs: what they ask for, and what is done with the answer.

namespace swaplight {
namespace fs = std::filesystem;

void StudioWindow::whenSaved(const std::function<void()>& then, const std::function<void()>& stay) {
  m_editor.commit();
  if (m_session.saving()) {
    m_session.afterSaving([this, then, stay] { whenSaved(then, stay); });
    return;
  }
  if (m_editor.saved() || !m_session.hasDocument()) {
    then();
    return;
  }
  const std::string name = m_session.file().empty() ? "This session" : m_session.file().filename().string();
  // What is changed while it is being saved is asked about again.
  const auto save = [this, again = [this, then, stay] { whenSaved(then, stay); }] {
    if (m_session.file().empty())
      askForSaveName(again);
    else
      m_session.save(again);
  };
  m_unsaved.ask({name, save, then, stay});
  m_window.requestFrames();
}

void StudioWindow::askAboutWaitingSet() {
  if (!m_session.setWaits() || m_session.saving() || openDialogs() != 0) return;
  m_messages.info("What was to be opened is there. What is open was changed meanwhile.");
  whenSaved([this] { m_session.openWaiting(); }, [this] { m_session.leaveWaiting(); });
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
                 [this](const fs::path& file) { useOnSet(file); }});
}

/// Asks about what is unsaved only where some of it would stay behind.
void StudioWindow::useOnSet(const fs::path& file) {
  const auto use = [this, file] { m_session.useOnSet(file); };
  m_editor.commit();
  try {
    const fs::path source = sourceFile(file);
    if (documentForSet(m_editor.document(), source, captureOfSource(*m_colors.config(), source)).complete)
      return use();
  } catch (const std::exception&) {
    return use();  // which says why it cannot be
  }
  whenSaved(use);
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
  std::vector<fs::path> inputs;
  try {
    inputs = filesOfDocument(m_editor.document());
  } catch (const InputError&) {  // gone meanwhile: the export says it
  }
  m_export.open((named.filename() == "capture.json" ? named.parent_path().filename() : named.stem()).string(),
                named.parent_path(), kind, std::move(inputs));
}

void StudioWindow::askForExportName() {
  const fs::path file = m_export.file();
  m_chooser.ask({"Export to", "Choose", formatsOf(m_export.choices().kind), true, file.filename().string(),
                 file.parent_path(), [this](const fs::path& chosen) { m_export.setFile(chosen); }});
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

}  // namespace swaplight
