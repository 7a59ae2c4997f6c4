#include "ui/camera_look/filter_shelf.h"

#include <fmt/ranges.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <map>

#include "ui/camera_look/filter_list.h"
#include "ui/camera_look/thumbnail.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kLeastHeight = 150;
constexpr float kThumbnailWidth = 64, kThumbnailHeight = 36;

using Filters = std::vector<std::shared_ptr<const Filter>>;

std::string tipOf(const Filter& filter) {
  const char* light =
      filter.space == FilterSpace::SceneLinear ? "Works on light: put it before filters of the display."
      : filter.space == FilterSpace::Display   ? "Works on what the display shows."
                                               : "Works on light and on what the display shows.";
  std::string tip = filter.description + "\n" + light + "\nClick to add it, or drag it.";
  for (const std::string& note : filter.notes) tip += "\n" + note;
  return tip;
}

void drawFilter(ViewerContext& studio, const Filter& filter) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = px(kThumbnailHeight), width = px(kThumbnailWidth);
  if (ImGui::Selectable(("##" + filter.name).c_str(), false, 0, ImVec2(0, height)))
    addToLook(studio, filter.name);
  const bool seen = ImGui::IsItemVisible();
  markItem({"filter.", filter.name});
  if (seen) {
    drawThumbnail(studio, "filter " + filter.name, {"", {{filter.name, true, {}, {}}}, {}, {}}, at,
                  ImVec2(at.x + width, at.y + height));
    const float line = (height - ImGui::GetTextLineHeight()) / 2;
    ImGui::GetWindowDrawList()->AddText(ImVec2(at.x + width + px(8), at.y + line), kText,
                                        filter.name.c_str());
  }
  tooltip(tipOf(filter).c_str());
  if (ImGui::BeginDragDropSource()) {
    ImGui::SetDragDropPayload(kDraggedFilter, filter.name.c_str(), filter.name.size() + 1);
    ImGui::TextUnformatted(filter.name.c_str());
    ImGui::EndDragDropSource();
  }
}

/// A filter of the look that is dropped on the library comes back with its parameters as defaults.
void dropStageHere(ViewerContext& studio) {
  if (!ImGui::BeginDragDropTarget()) return;
  if (const ImGuiPayload* stage = ImGui::AcceptDragDropPayload(kDraggedStage))
    keepStage(studio, *static_cast<const size_t*>(stage->Data));
  ImGui::EndDragDropTarget();
}

std::string textOf(const Filter& filter) {
  return fmt::format("{} {} {}", filter.name, filter.description, fmt::join(filter.categories, " "));
}

void drawCategories(ViewerContext& studio, const Filters& filters) {
  std::map<std::string, Filters> byCategory;
  for (const auto& filter : filters)
    byCategory[filter->categories.empty() ? "Other" : filter->categories.front()].push_back(filter);
  for (const auto& [category, those] : byCategory) {
    const bool open = ImGui::TreeNodeEx(category.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth);
    markItem({"category.", category});
    tooltip(fmt::format("{} filters", those.size()).c_str());
    if (!open) continue;
    for (const auto& filter : those) drawFilter(studio, *filter);
    ImGui::TreePop();
  }
}

}  // namespace

void drawFilterShelf(ViewerContext& studio) {
  std::string& search = studio.cameraLook.search;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  ImGui::InputTextWithHint("##search", "Find a filter", &search);
  markItem("camera_look.search");
  tooltip("By words of its name, of what it does, or of its category.");
  ImGui::BeginChild("##shelf", ImVec2(0, std::max(ImGui::GetContentRegionAvail().y, px(kLeastHeight))));
  Filters found;
  for (const auto& filter : studio.seen.library().filters())
    if (filter->takesImage && matchesWords(textOf(*filter), search)) found.push_back(filter);
  if (search.empty()) {
    drawCategories(studio, found);
  } else {
    for (const auto& filter : found) drawFilter(studio, *filter);
    if (found.empty()) hint("No filter has these words.");
  }
  ImGui::EndChild();
  dropStageHere(studio);
}

}  // namespace swaplight
