#include "ui/edits/edit_list.h"

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "ui/edits/edit_parameters.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kRowHeight = 44;
constexpr float kLeastHeight = 140;  ///< of the list, below whatever else the panel holds
constexpr const char* kDragged = "swaplight edit";

/// What an edit does, below its name.
std::string detailWords(const Edit& edit) {
  std::string words = edit.lights.empty() ? "all lights" : fmt::format("{}", fmt::join(edit.lights, ", "));
  words += "  ·  " + operationSummary(edit.operation);
  if (actsOnBeta(edit.operation) && edit.energy == EnergyMode::Redistribute) words += "  ·  keeps total";
  if (edit.opacity < 1) words += fmt::format("  ·  {:.0f} %", 100 * edit.opacity);
  return words;
}

std::string nameOf(const Edit& edit) {
  return edit.name.empty() ? operationName(edit.operation) : edit.name;
}

void nameField(EditingContext& studio, size_t index) {
  EditsState& state = studio.editing;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - px(6));
  if (!state.nameFocused) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputText(
      "##name", &state.name, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  markItem("edits.name_field");
  if (!entered && !(state.nameFocused && !ImGui::IsItemActive())) {
    state.nameFocused = state.nameFocused || ImGui::IsItemActive();
    return;
  }
  const bool cancelled = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  state.renaming = -1;
  if (cancelled) return;
  Edit edit = *studio.document().edits.edits[index];
  edit.name = state.name;
  editEdit(studio, index, "Rename an edit", std::move(edit));
}

void beginRename(EditsState& state, size_t index, const Edit& edit) {
  state.renaming = static_cast<int>(index);
  state.name = nameOf(edit);
  state.nameFocused = false;
}

void remove(EditingContext& studio, size_t index) {
  EditStack edits = studio.document().edits;
  const std::string name = nameOf(*edits.edits[index]);
  edits.edits.erase(edits.edits.begin() + static_cast<ptrdiff_t>(index));
  studio.editing.chosen = -1;
  editEdits(studio, "Delete: " + name, std::move(edits));
}

void duplicate(EditingContext& studio, size_t index) {
  EditStack edits = studio.document().edits;
  Edit copy = *edits.edits[index];
  copy.name = nameOf(copy) + " copy";
  const std::string name = copy.name;
  edits.edits.insert(edits.edits.begin() + static_cast<ptrdiff_t>(index) + 1,
                     std::make_shared<const Edit>(std::move(copy)));
  studio.editing.chosen = static_cast<int>(index) + 1;
  studio.editing.open = false;
  editEdits(studio, "Duplicate: " + name, std::move(edits));
}

void move(EditingContext& studio, size_t from, size_t to) {
  if (from == to) return;
  EditStack edits = studio.document().edits;
  const auto edit = edits.edits[from];
  edits.edits.erase(edits.edits.begin() + static_cast<ptrdiff_t>(from));
  edits.edits.insert(edits.edits.begin() + static_cast<ptrdiff_t>(to), edit);
  studio.editing.chosen = static_cast<int>(to);
  editEdits(studio, "Move: " + nameOf(*edit), std::move(edits));
}

void menu(EditingContext& studio, size_t index) {
  const Edit& edit = *studio.document().edits.edits[index];
  const size_t last = studio.document().edits.edits.size() - 1;
  const auto line = [&](const char* words, const char* mark, bool enabled = true) {
    const bool clicked = ImGui::MenuItem(words, nullptr, false, enabled);
    markItem(mark);
    return clicked;
  };
  if (line("Rename", "edits.rename")) beginRename(studio.editing, index, edit);
  if (line("Duplicate", "edits.duplicate")) return duplicate(studio, index);
  if (line("Up", "edits.up", index < last)) return move(studio, index, index + 1);
  if (line("Down", "edits.down", index > 0)) return move(studio, index, index - 1);
  ImGui::Separator();
  if (line("Delete", "edits.delete")) remove(studio, index);
}

/// A row can be dragged onto another's place. True where that changed the list.
bool dragAndDrop(EditingContext& studio, size_t index) {
  const Edit& edit = *studio.document().edits.edits[index];
  if (ImGui::BeginDragDropSource()) {
    ImGui::SetDragDropPayload(kDragged, &index, sizeof(index));
    ImGui::TextUnformatted(nameOf(edit).c_str());
    ImGui::EndDragDropSource();
  }
  bool moved = false;
  if (ImGui::BeginDragDropTarget()) {
    if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kDragged)) {
      move(studio, *static_cast<const size_t*>(payload->Data), index);
      moved = true;
    }
    ImGui::EndDragDropTarget();
  }
  return moved;
}

/// Rows do not move under the mouse before a double-click has had its time.
void choose(EditsState& state, int index) {
  if (index >= 0) {
    state.closing = state.open && state.chosen != index ? state.chosen : -1;
    state.open = true;
    state.settling = true;
    state.closesAt = ImGui::GetTime() + 1.2 * ImGui::GetIO().MouseDoubleClickTime;
  }
  state.chosen = index;
  state.focused = true;
}

/// Scrolls to a row and what it shows, or as much of it as there is room for.
void reveal(float top, float bottom) {
  const float height = ImGui::GetWindowHeight();
  if (bottom - ImGui::GetScrollY() > height || top < ImGui::GetScrollY())
    ImGui::SetScrollY(std::min(top, std::max(bottom - height, 0.F)));
}

/// False where the list has changed, and the rows after it are not those that they were.
bool drawRow(EditingContext& studio, size_t index) {
  const std::shared_ptr<const Edit> edit = studio.document().edits.edits[index];
  EditsState& state = studio.editing;
  const std::string mark = fmt::format("edits.{}", index);
  const bool chosen = state.chosen == static_cast<int>(index);
  const ImVec2 start = ImGui::GetCursorPos();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, px(kRowHeight));
  const ImVec2 high(at.x + size.x, at.y + size.y);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(at, high, chosen ? kCardChosen : kCard, px(6));
  if (chosen) draw->AddRect(at, high, kAccent, px(6), 0, px(1));

  // All of the row but the eye: what can be dragged would take the eye's clicks.
  const float eye = px(36);
  ImGui::SetCursorPos(ImVec2(start.x + eye, start.y));
  if (ImGui::InvisibleButton("##row", ImVec2(size.x - eye, size.y))) {
    choose(state, chosen && state.open ? -1 : static_cast<int>(index));
  }
  ImGui::SetItemAllowOverlap();
  markItem(mark);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    state.chosen = static_cast<int>(index);
    beginRename(state, index, *edit);
  }
  if (dragAndDrop(studio, index)) return false;
  if (ImGui::BeginPopupContextItem("##menu")) {
    menu(studio, index);
    ImGui::EndPopup();
    if (studio.document().edits.edits.size() <= index || studio.document().edits.edits[index] != edit)
      return false;
  }
  const float side = px(26);
  ImGui::SetCursorPos(ImVec2(start.x + px(6), start.y + (size.y - side) / 2));
  if (toggleButton(kIconVisible, edit->on, kAccent, side, "Turn on or off")) {
    Edit changed = *edit;
    changed.on = !edit->on;
    editEdit(studio, index, nameOf(*edit) + (edit->on ? ": off" : ": on"), std::move(changed));
  }
  markItem({mark, ".on"});
  ImGui::SetCursorPos(ImVec2(start.x + px(40), start.y + px(4)));
  if (state.renaming == static_cast<int>(index)) {
    nameField(studio, index);
  } else {
    ImGui::PushClipRect(at, ImVec2(high.x - px(6), high.y), true);
    ImGui::TextUnformatted(nameOf(*edit).c_str());
    ImGui::SetCursorPos(ImVec2(start.x + px(40), start.y + px(23)));
    hint(detailWords(*edit));
    ImGui::PopClipRect();
  }
  ImGui::SetCursorPos(ImVec2(start.x, start.y + size.y + px(4)));
  const bool closing = state.closing == static_cast<int>(index) && ImGui::GetTime() < state.closesAt;
  if ((chosen || closing) && state.renaming != static_cast<int>(index)) {
    drawEditParameters(studio, index, state.open || closing);
    ImGui::Dummy(ImVec2(0, px(4)));
  }
  if (chosen && state.settling && ImGui::GetTime() >= state.closesAt) {
    state.settling = false;
    reveal(start.y, ImGui::GetCursorPosY());
  }
  return true;
}

}  // namespace

void editEdits(EditingContext& studio, const std::string& step, EditStack edits) {
  Document next = studio.document();
  next.edits = std::move(edits);
  studio.editor.edit(step, std::move(next));
}

void editEdit(EditingContext& studio, size_t index, const std::string& step, Edit edit) {
  EditStack edits = studio.document().edits;
  edits.replace(index, std::move(edit));
  editEdits(studio, step, std::move(edits));
}

void previewEdit(EditingContext& studio, size_t index, const std::string& step, Edit edit) {
  Document next = studio.document();
  next.edits.replace(index, std::move(edit));
  studio.editor.preview(step, std::move(next));
}

void renameEdit(EditingContext& studio, size_t index) {
  beginRename(studio.editing, index, *studio.document().edits.edits[index]);
}

void deleteEdit(EditingContext& studio, size_t index) {
  remove(studio, index);
}

void drawEditList(EditingContext& studio) {
  // Clicks elsewhere take the keys away from the list.
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows))
    studio.editing.focused = false;
  const size_t count = studio.document().edits.edits.size();
  if (studio.editing.chosen >= static_cast<int>(count)) studio.editing.chosen = -1;
  if (studio.editing.chosen < 0) studio.editing.settling = false;
  if (count == 0) {
    hint("No edits yet: paint, edit shadows,\nor add one.");
    return;
  }
  ImGui::BeginChild("##edits", ImVec2(0, std::max(ImGui::GetContentRegionAvail().y, px(kLeastHeight))));
  for (size_t i = count; i-- > 0;) {
    ImGui::PushID(static_cast<int>(i));
    const bool same = drawRow(studio, i);
    ImGui::PopID();
    if (!same) break;
  }
  ImGui::EndChild();
}

}  // namespace swaplight
