#include "ui/edits/stencil_panel.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <cmath>

#include "core/edit/mask/shape_handles.h"
#include "ui/edits/edit_list.h"
#include "ui/edits/paint_modes.h"
#include "ui/kit/action_widgets.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/panel_controls.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/tools/stencil_tool.h"

namespace swaplight {
namespace {

constexpr float kMostStencilFeather = 400;

void kinds(StencilState& state) {
  const float gap = px(4);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
  int column = 0;
  for (const StencilKind& one : stencilKinds()) {
    if (column++ % 2 == 1) ImGui::SameLine(0, gap);
    const bool chosen = state.stencil.shape == one.info.name;
    const std::string mark = std::string("stencil.") + one.info.name;
    if (choiceButton(one.stencil.label, chosen, width, mark.c_str(), one.stencil.tip))
      state.stencil.shape = one.info.name;
  }
}

/// What only this kind has. True where it changed.
bool ownValues(EditingContext& studio) {
  Stencil& stencil = studio.editing.stencil.stencil;
  const StencilKind& kind = kindOf(stencil);
  bool changed = false;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (kind.text) {
    changed = ImGui::InputTextWithHint("##words", "Text", &stencil.text);
    markItem("stencil.words");
  }
  if (kind.file) {
    const std::string name = std::filesystem::path(stencil.file).filename().string();
    actionTextButton(studio.actions, "stencil.choose_picture", name.empty() ? "Choose \u2026" : name.c_str(),
                     ImGui::GetContentRegionAvail().x);
  }
  if (kind.pattern) {
    int pattern = static_cast<int>(stencil.pattern);
    changed = ImGui::Combo("##pattern", &pattern, "Stripes\0Checks\0Dots\0");
    markItem("stencil.which_pattern");
    stencil.pattern = static_cast<PatternShape::Kind>(pattern);
  }
  if (kind.feather && labelledSlider("Feather", "stencil.feather", &stencil.feather, 0, kMostStencilFeather,
                                     "%.0f px", "Width of the soft edge, in image pixels.", kLogarithmic))
    changed = true;
  return changed;
}

}  // namespace

void drawStencilPanel(EditingContext& studio) {
  StencilState& state = studio.editing.stencil;
  drawPaintModes(studio);
  hint("Project light through");
  kinds(state);
  bool changed = ownValues(studio);
  if (ImGui::Checkbox("Invert", &state.invert)) changed = true;
  markItem("stencil.invert");
  tooltip("Light everywhere except inside the shape.");
  if (const Edit* chosen = chosenStencil(studio); changed && chosen && !state.going) {
    Edit edit = *chosen;
    edit.mask.front() = withStencil(edit.mask.front(), state.stencil);
    edit.mask.front().invert = state.invert;
    const std::string step = edit.name + ": gobo";
    previewEdit(studio, static_cast<size_t>(studio.editing.chosen), step, std::move(edit));
  }
  const Edit* placed = chosenStencil(studio);
  const bool movable = placed && !handlesOf(placed->mask.front()).empty();
  ImGui::PushTextWrapPos(0);
  hint(movable ? "Drag it or its handles, or drag elsewhere for another" : "Drag in the picture to place it");
  ImGui::PopTextWrapPos();
}

}  // namespace swaplight
