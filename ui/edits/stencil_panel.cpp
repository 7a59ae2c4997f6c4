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

using Kind = ShapeKind::Kind;

constexpr float kMostFeather = 400;

void kinds(StencilState& state) {
  struct Choice {
    Kind kind;
    const char* words;
    const char* mark;
    const char* tip;
  };
  constexpr Choice kChoices[] = {
      {Kind::Text, "Words", "stencil.text", "Drag: the words become as wide as the drag."},
      {Kind::Picture, "Picture", "stencil.picture",
       "A picture's brightness as a stencil, stretched over the drag."},
      {Kind::Rectangle, "Rectangle", "stencil.rectangle", "Drag from corner to corner. Shift: a square."},
      {Kind::Ellipse, "Ellipse", "stencil.ellipse", "Drag from corner to corner. Shift: a circle."},
      {Kind::Linear, "Gradient", "stencil.linear",
       "Drag from where all of it is to where nothing is. Shift: in steps of 45 degrees."},
      {Kind::Radial, "Round grad.", "stencil.radial", "Drag from the middle to the rim."},
      {Kind::Pattern, "Pattern", "stencil.pattern",
       "Stripes, checks or dots, as of a gobo in front of a lamp. Drag: how long a repeat is, and in which "
       "direction."}};
  const float gap = px(4);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
  int column = 0;
  for (const Choice& one : kChoices) {
    if (column++ % 2 == 1) ImGui::SameLine(0, gap);
    if (choiceButton(one.words, state.kind.kind == one.kind, width, one.mark, one.tip))
      state.kind.kind = one.kind;
  }
}

/// What only this kind has. True where it changed.
bool ownValues(EditingContext& studio) {
  ShapeKind& kind = studio.editing.stencil.kind;
  bool changed = false;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  if (kind.kind == Kind::Text) {
    changed = ImGui::InputTextWithHint("##words", "The words", &kind.text);
    markItem("stencil.words");
  } else if (kind.kind == Kind::Picture) {
    const std::string name = std::filesystem::path(kind.file).filename().string();
    actionTextButton(studio.actions, "stencil.choose_picture", name.empty() ? "Choose \u2026" : name.c_str(),
                     ImGui::GetContentRegionAvail().x);
  } else if (kind.kind == Kind::Pattern) {
    int pattern = static_cast<int>(kind.pattern);
    changed = ImGui::Combo("##pattern", &pattern, "Stripes\0Checks\0Dots\0");
    markItem("stencil.which_pattern");
    kind.pattern = static_cast<PatternShape::Kind>(pattern);
  }
  const bool soft = kind.kind != Kind::Picture && kind.kind != Kind::Linear && kind.kind != Kind::Radial;
  if (soft && labelledSlider("Soft edge", "stencil.feather", &kind.feather, 0, kMostFeather, "%.0f px",
                             "Over how many pixels of the picture its edge falls off.", kLogarithmic))
    changed = true;
  return changed;
}

}  // namespace

void drawStencilPanel(EditingContext& studio) {
  StencilState& state = studio.editing.stencil;
  drawPaintModes(studio);
  hint("Through");
  kinds(state);
  bool changed = ownValues(studio);
  if (ImGui::Checkbox("Around it instead", &state.invert)) changed = true;
  markItem("stencil.invert");
  tooltip("Everywhere but in the shape.");
  if (const Edit* chosen = chosenStencil(studio); changed && chosen && !state.going) {
    Edit edit = *chosen;
    edit.mask.front() = withKind(edit.mask.front(), state.kind);
    edit.mask.front().invert = state.invert;
    const std::string step = edit.name + ": stencil";
    previewEdit(studio, static_cast<size_t>(studio.editing.chosen), step, std::move(edit));
  }
  const Edit* placed = chosenStencil(studio);
  const bool movable = placed && !handlesOf(placed->mask.front()).empty();
  hint(movable ? "Drag it or its handles, or place another" : "Drag in the picture to place it");
}

}  // namespace swaplight
