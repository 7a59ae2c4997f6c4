#include "ui/edits/edit_list.h"
#include "ui/edits/edit_menu.h"
#include "ui/shell/studio_window.h"

namespace swaplight {

void StudioWindow::addEditActions() {
  const auto chosen = [this] {
    return m_session.set() && m_editing.chosen >= 0 &&
           m_editing.chosen < static_cast<int>(m_editor.document().edits.edits.size());
  };
  const auto focused = [this, chosen] { return m_layout.edits && m_editing.focused && chosen(); };
  const auto index = [this] { return static_cast<size_t>(m_editing.chosen); };
  m_actions.add({"edits.rename", "Rename the edit", "F2", "Give the chosen edit of the list another name.",
                 [this, index] { renameEdit(m_context, index()); }, focused});
  m_actions.add({"edits.delete", "Delete the edit", "Delete", "Take the chosen edit out of the list.",
                 [this, index] { deleteEdit(m_context, index()); }, focused});
  m_actions.add(
      {"edits.add_picture", "\u03b2 from a file \u2026", "",
       "Add a beta map that was edited elsewhere as an edit of the chosen light.",
       [this] { askForBetaMap([this](const std::string& file) { addPictureEdit(m_context, file); }); },
       [this] { return m_session.set() && !m_editor.document().rig.lights.empty(); }});
  m_actions.add({"edits.choose_picture", "Another \u03b2 file \u2026", "",
                 "Choose another file for the edit of the list that takes its beta map from one.",
                 [this, index] {
                   askForBetaMap([this, at = index()](const std::string& file) {
                     setPictureOfEdit(m_context, at, file);
                   });
                 },
                 [this, chosen, index] {
                   return chosen() && std::holds_alternative<PictureOperation>(
                                          m_editor.document().edits.edits[index()]->operation);
                 }});
}

void StudioWindow::askForBetaMap(const std::function<void(const std::string&)>& answer) {
  FileChooser::Question question;
  question.title = "A beta map of the picture's size: EXR or PNG";
  question.button = "Use";
  question.extensions = {".exr", ".png"};
  question.folder = m_editor.document().source.parent_path();
  question.answer = [answer](const std::filesystem::path& file) { answer(file.string()); };
  m_chooser.ask(std::move(question));
}

}  // namespace swaplight
