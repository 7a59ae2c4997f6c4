#include "ui/camera_look/filter_list.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/filter/kept_filter.h"
#include "ui/camera/camera_look_edit.h"
#include "ui/camera_look/thumbnail.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kStageHeight = 36;
constexpr float kStageThumbnail = 58;

/// Why the filter is left out of the picture; empty where it is drawn.
std::string problemOf(const ViewerContext& studio, const FilterStage& stage) {
  for (const std::string& line : studio.seen.leftOut())
    if (stage.on && line.find(stage.filter) != std::string::npos) return line;
  return {};
}

/// The look as far as a filter of it, and no further: what the picture is after that filter.
FilterPipeline upTo(FilterPipeline look, size_t index) {
  look.stages.resize(index + 1);
  return look;
}

void stageMenu(ViewerContext& studio, size_t index) {
  const auto last = studio.document().cameraLook.stages.size() - 1;
  const auto line = [](const char* words, const char* mark, bool enabled = true) {
    const bool clicked = ImGui::MenuItem(words, nullptr, false, enabled);
    markItem(mark);
    return clicked;
  };
  int& chosen = studio.cameraLook.chosen;
  if (line("Keep these settings in the library", "camera_look.keep")) {
    keepStage(studio, index);
  } else if (line("Duplicate", "camera_look.duplicate")) {
    duplicateFilter(studio.editor, index);
    chosen = static_cast<int>(index) + 1;
  } else if (line("Up", "camera_look.up", index > 0)) {
    moveFilter(studio.editor, index, index - 1);
    chosen = static_cast<int>(index) - 1;
  } else if (line("Down", "camera_look.down", index < last)) {
    moveFilter(studio.editor, index, index + 1);
    chosen = static_cast<int>(index) + 1;
  } else if (line("Remove", "camera_look.remove_filter")) {
    removeFilter(studio.editor, index);
    chosen = -1;
  }
}

/// Dropped here: another filter of the list, or one of the library. True where that changed the list.
bool dropOn(ViewerContext& studio, size_t index) {
  if (!ImGui::BeginDragDropTarget()) return false;
  bool changed = false;
  if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kDraggedStage)) {
    moveFilter(studio.editor, *static_cast<const size_t*>(payload->Data), index);
    studio.cameraLook.chosen = static_cast<int>(index);
    changed = true;
  } else if (const ImGuiPayload* filter = ImGui::AcceptDragDropPayload(kDraggedFilter)) {
    addToLook(studio, static_cast<const char*>(filter->Data), index);
    changed = true;
  }
  ImGui::EndDragDropTarget();
  return changed;
}

/// False where the list has changed, and the rows after it are not those that they were.
bool drawStage(ViewerContext& studio, size_t index) {
  const FilterStage stage = studio.document().cameraLook.stages[index];
  const std::string mark = fmt::format("camera_look.{}", index);
  const bool chosen = studio.cameraLook.chosen == static_cast<int>(index);
  const ImVec2 start = ImGui::GetCursorPos();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, px(kStageHeight));
  const ImVec2 high(at.x + size.x, at.y + size.y);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(at, high, chosen ? kCardChosen : kCard, px(5));
  if (chosen) draw->AddRect(at, high, kAccent, px(5), 0, px(1));
  const float eye = px(34), close = px(28), thumbnail = px(kStageThumbnail);
  ImGui::SetCursorPos(ImVec2(start.x + eye, start.y));
  if (ImGui::InvisibleButton("##stage", ImVec2(size.x - eye - close, size.y)))
    studio.cameraLook.chosen = chosen ? -1 : static_cast<int>(index);
  markItem(mark);
  if (ImGui::IsItemVisible() && stage.on)
    drawThumbnail(studio, fmt::format("stage {}", index), upTo(studio.document().cameraLook, index),
                  ImVec2(high.x - close - thumbnail, at.y + px(2)), ImVec2(high.x - close, high.y - px(2)));
  const std::string problem = problemOf(studio, stage);
  if (!problem.empty()) tooltip(("Left out: " + problem).c_str());
  if (ImGui::BeginDragDropSource()) {
    ImGui::SetDragDropPayload(kDraggedStage, &index, sizeof(index));
    ImGui::TextUnformatted(stageName(stage).c_str());
    ImGui::EndDragDropSource();
  }
  if (dropOn(studio, index)) return false;
  const size_t count = studio.document().cameraLook.stages.size();
  if (ImGui::BeginPopupContextItem("##menu")) {
    stageMenu(studio, index);
    ImGui::EndPopup();
    if (studio.document().cameraLook.stages.size() != count ||
        studio.document().cameraLook.stages[index] != stage)
      return false;
  }
  const float side = px(24);
  ImGui::SetCursorPos(ImVec2(start.x + px(5), start.y + (size.y - side) / 2));
  if (toggleButton(kIconVisible, stage.on, kAccent, side, "Turn on or off"))
    switchFilter(studio.editor, index, !stage.on);
  markItem({mark, ".on"});
  ImGui::SetCursorPos(ImVec2(start.x + px(38), start.y + (size.y - ImGui::GetTextLineHeight()) / 2));
  ImGui::PushClipRect(at, ImVec2(high.x - close - thumbnail, high.y), true);
  const ImU32 color = !problem.empty() ? kMute : stage.on ? kText : kFaint;
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextUnformatted(stageName(stage).c_str());
  ImGui::PopStyleColor();
  ImGui::PopClipRect();
  ImGui::SetCursorPos(ImVec2(high.x - at.x + start.x - close, start.y + (size.y - side) / 2));
  const bool removed = toggleButton(kIconClose, false, kAccent, side, "Remove the filter");
  markItem({mark, ".remove"});
  ImGui::SetCursorPos(ImVec2(start.x, start.y + size.y + px(3)));
  if (!removed) return true;
  studio.cameraLook.chosen = -1;
  removeFilter(studio.editor, index);
  return false;
}

}  // namespace

void addToLook(ViewerContext& studio, const std::string& filter, std::optional<size_t> at) {
  studio.cameraLook.chosen = static_cast<int>(addFilter(studio.editor, filter, at));
}

void keepStage(ViewerContext& studio, size_t index) try {
  const FilterPipeline& look = studio.document().cameraLook;
  const ResolvedStage stage =
      resolveStage(studio.seen.library(), look.stages.at(index), look.folder, look.name);
  const std::filesystem::path file = keepFilter(stage, personalFilterFolders().front().path);
  studio.seen.readLibraryAgain();
  studio.messages.info("The library has " + file.stem().string() + " now: " + file.string());
} catch (const InputError& error) {
  studio.messages.error(error.what());
}

void drawFilterList(ViewerContext& studio) {
  const size_t count = studio.document().cameraLook.stages.size();
  for (size_t i = 0; i < count; ++i) {
    ImGui::PushID(static_cast<int>(i));
    const bool same = drawStage(studio, i);
    ImGui::PopID();
    if (!same) return;
  }
  // What is dropped below the last one goes to the end.
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, px(count == 0 ? 44 : 14));
  ImGui::Dummy(size);
  markItem("camera_look.end");
  if (ImGui::BeginDragDropTarget()) {
    if (const ImGuiPayload* filter = ImGui::AcceptDragDropPayload(kDraggedFilter))
      addToLook(studio, static_cast<const char*>(filter->Data));
    else if (const ImGuiPayload* stage = ImGui::AcceptDragDropPayload(kDraggedStage)) {
      moveFilter(studio.editor, *static_cast<const size_t*>(stage->Data), count - 1);
      studio.cameraLook.chosen = static_cast<int>(count) - 1;
    }
    ImGui::EndDragDropTarget();
  }
  if (count > 0) return;
  const ImVec2 after = ImGui::GetCursorPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + px(4)));
  hint("No filters yet: click one below, or drag\nit here or onto the picture.");
  ImGui::SetCursorPos(after);
}

}  // namespace swaplight
