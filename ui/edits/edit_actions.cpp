#include "ui/edits/edits_actions.h"

#include "ui/edits/edit_list.h"
#include "ui/edits/edit_menu.h"

namespace swaplight {
namespace {

void askForBetaMap(const EditingContext& studio, FileChooser& chooser,
                   const std::function<void(const std::string&)>& answer) {
  FileChooser::Question question;
  question.title = "Choose a beta map of the picture's size (EXR or PNG)";
  question.button = "Use";
  question.extensions = {".exr", ".png"};
  question.folder = studio.document().source.parent_path();
  question.answer = [answer](const std::filesystem::path& file) { answer(file.string()); };
  chooser.ask(std::move(question));
}

}  // namespace

void addEditActions(ActionTable& actions, EditingContext& studio, FileChooser& chooser) {
  const auto chosen = [&studio] {
    return studio.set() && studio.editing.chosen >= 0 &&
           studio.editing.chosen < static_cast<int>(studio.document().edits.edits.size());
  };
  const auto focused = [&studio, chosen] {
    return studio.layout.edits && studio.editing.focused && chosen();
  };
  const auto index = [&studio] { return static_cast<size_t>(studio.editing.chosen); };
  actions.add({"edits.rename", "Rename the edit", "F2", "Rename the selected edit.",
               [&studio, index] { renameEdit(studio, index()); }, focused});
  actions.add({"edits.delete", "Delete the edit", "Delete", "Delete the selected edit.",
               [&studio, index] { deleteEdit(studio, index()); }, focused});
  actions.add({"edits.add_picture", "Beta map from a file \u2026", "",
               "Add a beta map edited in another program to the selected light.",
               [&studio, &chooser] {
                 askForBetaMap(studio, chooser,
                               [&studio](const std::string& file) { addPictureEdit(studio, file); });
               },
               [&studio] { return studio.hasLights(); }});
  actions.add({"edits.choose_picture", "Replace beta map \u2026", "",
               "Choose another file for the selected beta map edit.",
               [&studio, &chooser, index] {
                 askForBetaMap(studio, chooser, [&studio, at = index()](const std::string& file) {
                   setPictureOfEdit(studio, at, file);
                 });
               },
               [&studio, chosen, index] {
                 return chosen() && std::holds_alternative<BetaMapOperation>(
                                        studio.document().edits.edits[index()]->operation);
               }});
}

}  // namespace swaplight
