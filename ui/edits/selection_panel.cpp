#include "ui/edits/selection_panel.h"

#include <imgui.h>

#include <cmath>

#include "ui/control/light_edit.h"
#include "ui/edits/edit_list.h"
#include "ui/kit/action_widgets.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/panel_controls.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/tools/selection_tool.h"

namespace swaplight {
namespace {

using Kind = SelectionState::Kind;

constexpr float kMostSelectionFeather = 400;
/// Below the kinds, whichever is chosen: what stands further down stays where it is.
constexpr float kDetailRows = 3;

void kinds(SelectionState& state, const std::string& light) {
  struct Choice {
    Kind kind;
    const char* words;
    const char* mark;
    std::string tip;
  };
  const Choice choices[] = {
      {Kind::Lasso, "Lasso", "select.lasso", "Draw around an area."},
      {Kind::Rectangle, "Rectangle", "select.rectangle", "Drag from corner to corner."},
      {Kind::Ellipse, "Ellipse", "select.ellipse", "Drag across its bounding box."},
      {Kind::Similar, "Similar", "select.similar",
       "Click to select pixels similar to the one under the pointer."},
      {Kind::Shadow, "Shadow", "select.shadow", "Click into a shadow of " + light + ": this shadow."}};
  const float gap = px(4);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
  int column = 0;
  for (const Choice& one : choices) {
    if (column++ % 2 == 1) ImGui::SameLine(0, gap);
    if (choiceButton(one.words, state.kind == one.kind, width, one.mark, one.tip.c_str()))
      state.kind = one.kind;
  }
}

void similar(SelectionState& state) {
  using By = SimilarShape::By;
  const float gap = px(4);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
  if (choiceButton("by colour", state.by == By::Color, width, "select.by_color",
                   "Similar in colour with every light at unit white."))
    state.by = By::Color;
  ImGui::SameLine(0, gap);
  if (choiceButton("by lighting", state.by == By::Share, width, "select.by_share",
                   "Similar in each light's share, whatever the colour."))
    state.by = By::Share;
  percentSlider("Tolerance", "select.tolerance", &state.tolerance, 60, "How different pixels may be.");
  ImGui::Checkbox("Contiguous", &state.connected);
  markItem("select.connected");
}

void shadows(EditingContext& studio, const LightSetting& light) {
  if (ImGui::Button(("All shadows of " + light.title()).c_str(), ImVec2(ImGui::GetContentRegionAvail().x, 0)))
    selectShadows(studio, light.light);
  markItem("select.all_shadows");
  if (studio.edits.findingShadows()) hint("Finding shadows \u2026");
}

/// The selected edit, where it acts within other bounds than the selection's; else nullptr.
const Edit* editToLimit(const EditingContext& studio) {
  const int chosen = studio.editing.chosen;
  const auto& edits = studio.document().edits.edits;
  if (chosen < 0 || chosen >= static_cast<int>(edits.size())) return nullptr;
  const Edit* edit = edits[static_cast<size_t>(chosen)].get();
  return selectionOf(edit->mask) == studio.document().selection ? nullptr : edit;
}

}  // namespace

void drawSelectionPanel(EditingContext& studio) {
  SelectionState& state = studio.editing.selection;
  const LightSetting& light = studio.document().rig.lights[shownLight(studio)];
  ImGui::PushFont(fonts().strong);
  ImGui::TextUnformatted("Select");
  ImGui::PopFont();
  tooltip("The brush, gobos, gradients and new edits stay inside the selection.");
  kinds(state, light.title());
  const float top = ImGui::GetCursorPosY();
  if (state.kind == Kind::Similar) similar(state);
  if (state.kind == Kind::Shadow) shadows(studio, light);
  ImGui::SetCursorPosY(top + kDetailRows * ImGui::GetFrameHeightWithSpacing());
  hint("Shift adds, Alt subtracts");
}

void drawSelectionBar(EditingContext& studio) {
  const Mask& selection = studio.document().selection;
  const bool none = selection.empty();
  if (none && studio.tool != &kSelect) return;
  hint(none ? "Nothing is selected" : "Edits stay inside the selection");
  if (none) markItem("select.none");
  ImGui::BeginDisabled(none);
  float feather = none ? 0 : featherOf(selection);
  if (labelledSlider("Feather", "select.feather", &feather, 0, kMostSelectionFeather, "%.0f px",
                     "Width of the soft edge, in image pixels.", kLogarithmic)) {
    Document next = studio.document();
    next.selection = featheredSelection(selection, std::round(feather));
    studio.editor.preview("Feather the selection", std::move(next));
  }
  const float gap = px(4);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
  actionTextButton(studio.actions, "select.invert", "Invert", width);
  ImGui::SameLine(0, gap);
  actionTextButton(studio.actions, "select.clear", "Deselect", width);
  ImGui::EndDisabled();
  const Edit* edit = none ? nullptr : editToLimit(studio);
  ImGui::BeginDisabled(!edit);
  if (ImGui::Button("Limit the selected edit to it", ImVec2(ImGui::GetContentRegionAvail().x, 0)) && edit) {
    Edit restricted = *edit;
    restricted.mask = maskWithin(edit->mask, selection);
    editEdit(studio, static_cast<size_t>(studio.editing.chosen), "Limit to the selection",
             std::move(restricted));
  }
  ImGui::EndDisabled();
  markItem("select.restrict");
}

}  // namespace swaplight
