#include "ui/edits/edit_menu.h"

#include <fmt/ranges.h>
#include <imgui.h>

#include "core/edit/apply/gel_mixing.h"
#include "core/edit/mask/selection.h"
#include "ui/control/light_edit.h"
#include "ui/edits/edit_list.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/light_words.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/tools/new_light.h"

namespace swaplight {
namespace {

/// An edit of the chosen lights, within the selection.
Edit newEdit(const EditingContext& studio, const std::string& what, const Operation& operation,
             EnergyMode energy) {
  const std::vector<LightSetting>& lights = studio.document().rig.lights;
  const LightSetting& light = lights[shownLight(studio)];
  // Two lamps never stand in one place, and two lights have no beta map in common.
  const bool ofOne = std::holds_alternative<PlaceOperation>(operation) ||
                     std::holds_alternative<BetaMapOperation>(operation);
  std::vector<std::string> titles;
  Edit edit;
  for (const size_t i : ofOne ? std::vector{shownLight(studio)} : lightsFor(studio, shownLight(studio))) {
    edit.lights.push_back(lights[i].light);
    titles.push_back(lights[i].title());
  }
  edit.name = fmt::format("{}, {}", what, fmt::join(titles, " + "));
  edit.energy = energy;
  edit.operation = operation;
  edit.mask = maskWithin({}, studio.document().selection);
  if (auto* recolor = std::get_if<RecolorOperation>(&edit.operation)) {
    edit.name = what;
    edit.lights.clear();
    recolor->from = recolor->to = studio.edits.surfaceColor(edit.mask);
  }
  if (auto* gel = std::get_if<UnknownGelOperation>(&edit.operation)) {
    edit.name = what;
    edit.lights.clear();
    edit.mask.clear();  // a gel has one colour
    *gel = solvedGel(*studio.set()->original).value_or(*gel);
  }
  if (auto* placed = std::get_if<PlaceOperation>(&edit.operation)) {
    const LampPlaces& told = studio.document().edits.lampPlaces;
    if (const auto place = told.find(light.light); place != told.end())
      *placed = PlaceOperation::at(place->second);
  }
  // With three lights somebody has to say which two change places.
  if (swapsTwoLights(operation) && studio.document().rig.lights.size() == 2) edit.lights.clear();
  return edit;
}

std::vector<std::string> namesOf(const Rig& rig) {
  std::vector<std::string> names;
  for (const LightSetting& light : rig.lights) names.push_back(light.light);
  return names;
}

/// The list will show all of the last edit.
void openLast(EditingContext& studio, const EditStack& edits) {
  studio.editing.chosen = static_cast<int>(edits.edits.size()) - 1;
  studio.editing.open = true;
  studio.editing.settling = true;
  studio.editing.closesAt = 0;
}

/// An edit of lights that give nothing now is kept, and shows later; of one that keeps the total there is
/// what it takes from the others.
void sayWhatHides(EditingContext& studio, const Edit& edit) {
  const Rig& rig = studio.document().rig;
  std::string words = unseenEditWords(rig, edit.lights, "edits");
  if (words.empty()) return;
  const bool others = actsOnBeta(edit.operation) && edit.energy == EnergyMode::Redistribute &&
                      unseenEditWords(rig, namesOf(rig), "edits").empty();
  if (others) words += " What they take from other lights is seen now.";
  studio.messages.info(words);
}

void append(EditingContext& studio, const std::string& what, Edit edit) {
  sayWhatHides(studio, edit);
  EditStack edits = studio.document().edits;
  edits.append(std::move(edit));
  openLast(studio, edits);
  editEdits(studio, "Add: " + what, std::move(edits));
}

/// A light that the set never had, and the edit that says where its lamp stands.
void appendNewLamp(EditingContext& studio) {
  Document next = studio.document();
  Edit edit;
  edit.lights = {addNewLight(studio, "lamp", next)};
  edit.name = "New lamp, " + edit.lights.front();
  edit.energy = EnergyMode::Add;
  edit.operation = PlaceOperation::initial();
  edit.mask = maskWithin({}, studio.document().selection);
  next.edits.append(std::move(edit));
  openLast(studio, next.edits);
  studio.editor.edit("Add: New lamp", std::move(next));
}

EditedLights lightsOf(const EditingContext& studio) {
  return editedLights(*studio.set()->original, studio.document().edits);
}

/// A file is being read: a way to stop it.
void reading(EditingContext& studio, float width) {
  if (ImGui::Button("Stop", ImVec2(width, 0))) studio.edits.files().stop();
  markItem("edits.stop");
  tooltip("Reading a beta map from a file.");
}

}  // namespace

void drawAddEdit(EditingContext& studio, float width) {
  if (studio.edits.files().choosing()) return reading(studio, width);
  if (ImGui::Button("Add \u2026", ImVec2(width, 0))) ImGui::OpenPopup("##add edit");
  markItem("edits.add");
  tooltip("Add an edit to the selected lights.");
  if (!ImGui::BeginPopup("##add edit")) return;
  forEachOperation([&]<typename T>(const T& operation) {
    if (!T::info.inMenu) return;
    if (std::is_same_v<T, UnknownGelOperation> && !solvedGel(*studio.set()->original)) return;
    if (ImGui::MenuItem(T::info.title))
      append(studio, T::info.title, newEdit(studio, T::info.title, operation, EnergyMode::Redistribute));
    markItem({"add.", T::info.name});
    tooltip(T::info.tip);
  });
  if (ImGui::MenuItem("New lamp")) appendNewLamp(studio);
  markItem("add.new_lamp");
  tooltip(
      "Adds a light that the set never had, from any side, by how the surfaces are turned. Say first where "
      "the lamps of three lights stood. It throws no shadows.");
  ImGui::Separator();
  if (ImGui::MenuItem("Beta map from a file \u2026")) studio.actions.run("edits.add_picture");
  markItem("add.picture");
  tooltip("Use a beta map edited in another program: an EXR or PNG of the same size as the picture.");
  if (ImGui::MenuItem("Export beta maps \u2026")) studio.actions.run("file.export_beta");
  markItem("add.export");
  tooltip("Export the lights' current beta maps for an image editor.");
  if (ImGui::MenuItem("Shadows \u2026") && !studio.layout.shadows) studio.actions.run("view.shadows");
  markItem("add.shadows");
  tooltip("Find and edit the light's shadows.");
  ImGui::EndPopup();
}

void addPictureEdit(EditingContext& studio, const std::string& file) {
  const Edit edit = newEdit(studio, "From a file", BetaMapOperation{file, ""}, EnergyMode::Redistribute);
  studio.edits.files().choose(edit, lightsOf(studio),
                              [&studio, edit] { append(studio, "From a file", edit); });
}

void setPictureOfEdit(EditingContext& studio, size_t index, const std::string& file) {
  if (index >= studio.document().edits.edits.size()) return;
  const std::shared_ptr<const Edit> before = studio.document().edits.edits[index];
  Edit edit = *before;
  auto& picture = std::get<BetaMapOperation>(edit.operation);
  if (picture.file != file) picture = {file, ""};
  studio.edits.files().choose(edit, lightsOf(studio), [&studio, before, index, edit] {
    const auto& edits = studio.document().edits.edits;
    if (index >= edits.size() || edits[index] != before) return;
    if (edit == *before) return studio.edits.readFilesAgain();
    editEdit(studio, index, "Another beta map", edit);
  });
}

}  // namespace swaplight
