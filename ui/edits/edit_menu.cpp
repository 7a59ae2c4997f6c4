#include "ui/edits/edit_menu.h"

#include <imgui.h>

#include <array>

#include "core/edit/mask/selection.h"
#include "ui/control/light_edit.h"
#include "ui/edits/edit_list.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

struct Choice {
  const char* words;
  const char* mark;
  const char* tip;
  Operation operation;
  Meaning meaning;
};

const std::array<Choice, 6>& choices() {
  static const std::array<Choice, 6> all{
      {{"Curve", "add.curve",
        "Less of the light where there is little, more where there is much, or as you draw it.",
        CurveOperation{}, Meaning::Share},
       {"Gain and offset", "add.gain", "The light's part times a number, plus a number.", GainOperation{},
        Meaning::Share},
       {"Fill", "add.fill", "The light has the same part of the picture everywhere; 0 % takes it away.",
        FillOperation{0.5F}, Meaning::Share},
       {"Invert", "add.invert",
        "The light goes where it was not, and leaves where it was. For two lights: they change places.",
        InvertOperation{}, Meaning::Share},
       {"Blur", "add.blur", "The light's borders and shadows become softer.", BlurOperation{},
        Meaning::Share},
       {"Sharpen", "add.sharpen", "The light's borders and shadows become harder.", SharpenOperation{},
        Meaning::Share}}};
  return all;
}

/// An edit of the chosen light, within the selection.
Edit newEdit(const EditingContext& studio, const std::string& what, const Operation& operation,
             Meaning meaning) {
  const LightSetting& light = studio.document().rig.lights[shownLight(studio)];
  Edit edit;
  edit.name = what + ", " + light.title();
  edit.lights = {light.light};
  edit.meaning = meaning;
  edit.operation = operation;
  edit.mask = maskWithin({}, studio.document().selection);
  // Two lights change places; a third has to be told which.
  if (std::holds_alternative<InvertOperation>(operation) && studio.document().rig.lights.size() == 2)
    edit.lights.clear();
  return edit;
}

void append(EditingContext& studio, const std::string& what, Edit edit) {
  EditStack edits = studio.document().edits;
  edits.append(std::move(edit));
  studio.editing.chosen = static_cast<int>(edits.edits.size()) - 1;
  studio.editing.open = true;
  studio.editing.settling = true;
  studio.editing.closesAt = 0;
  editEdits(studio, "Add: " + what, std::move(edits));
}

EditedLights lightsOf(const EditingContext& studio) {
  return editedLights(*studio.set()->original, studio.document().edits);
}

/// A file is being read: a way to stop it.
void reading(EditingContext& studio, float width) {
  if (ImGui::Button("Stop", ImVec2(width, 0))) studio.edits.files().stop();
  markItem("edits.stop");
  tooltip("A beta map is being read from a file.");
}

}  // namespace

void drawAddEdit(EditingContext& studio, float width) {
  if (studio.edits.files().choosing()) return reading(studio, width);
  if (ImGui::Button("Add \u2026", ImVec2(width, 0))) ImGui::OpenPopup("##add edit");
  markItem("edits.add");
  tooltip("A new edit of the chosen light.");
  if (!ImGui::BeginPopup("##add edit")) return;
  for (const Choice& choice : choices()) {
    if (ImGui::MenuItem(choice.words))
      append(studio, choice.words, newEdit(studio, choice.words, choice.operation, choice.meaning));
    markItem(choice.mark);
    tooltip(choice.tip);
  }
  ImGui::Separator();
  if (ImGui::MenuItem("From a file \u2026")) studio.actions.run("edits.add_picture");
  markItem("add.picture");
  tooltip("The light's beta map, edited elsewhere: an EXR or PNG of the picture's size.");
  if (ImGui::MenuItem("To a file \u2026")) studio.actions.run("file.export_beta");
  markItem("add.export");
  tooltip("Write the lights' beta maps as they are now, for an image editor.");
  if (ImGui::MenuItem("Shadows \u2026") && !studio.layout.shadows) studio.actions.run("view.shadows");
  markItem("add.shadows");
  tooltip("Find the light's shadows and change them.");
  ImGui::EndPopup();
}

void addPictureEdit(EditingContext& studio, const std::string& file) {
  const Edit edit = newEdit(studio, "From a file", PictureOperation{file, ""}, Meaning::Share);
  studio.edits.files().choose(edit, lightsOf(studio),
                              [&studio, edit] { append(studio, "From a file", edit); });
}

void setPictureOfEdit(EditingContext& studio, size_t index, const std::string& file) {
  if (index >= studio.document().edits.edits.size()) return;
  const std::shared_ptr<const Edit> before = studio.document().edits.edits[index];
  Edit edit = *before;
  auto& picture = std::get<PictureOperation>(edit.operation);
  if (picture.file != file) picture = {file, ""};
  studio.edits.files().choose(edit, lightsOf(studio), [&studio, before, index, edit] {
    const auto& edits = studio.document().edits.edits;
    if (index >= edits.size() || edits[index] != before) return;
    if (edit == *before) return studio.edits.readFilesAgain();
    editEdit(studio, index, "Another beta map", edit);
  });
}

}  // namespace swaplight
