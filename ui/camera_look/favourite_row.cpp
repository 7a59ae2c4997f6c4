#include "ui/camera_look/favourite_row.h"

#include <fmt/ranges.h>
#include <imgui.h>

#include <algorithm>
#include <vector>

#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kChipGap = 4, kChipPadding = 7, kMoreWidth = 22, kMostChip = 170;
constexpr int kChipLines = 2;

std::string tipOf(const FilterPipeline& look, bool on) {
  std::vector<std::string> filters;
  for (const FilterStage& stage : look.stages) filters.push_back(stage.filter);
  return fmt::format(
      "{}\n{}", fmt::join(filters, ", "),
      on ? "Click for the plain picture." : "Click to see the picture through it. F10 shows its filters.");
}

float widthOf(const FilterPipeline& look) {
  return std::min(ImGui::CalcTextSize(look.name.c_str()).x + 2 * px(kChipPadding), px(kMostChip));
}

/// True when clicked.
bool lookChip(const FilterPipeline& look, bool on) {
  for (const ImGuiCol color : {ImGuiCol_Button, ImGuiCol_ButtonHovered})
    if (on) ImGui::PushStyleColor(color, kAccent);
  const bool clicked = ImGui::Button(look.name.c_str(), ImVec2(widthOf(look), 0));
  if (on) ImGui::PopStyleColor(2);
  markItem({"favourite.", look.name});
  tooltip(tipOf(look, on).c_str());
  return clicked;
}

void moreLooks(const LookChoice& studio) {
  if (ImGui::Button(kIconDown, ImVec2(px(kMoreWidth), 0))) {
    studio.shelf.readAgain();  // files may have been put there meanwhile
    ImGui::OpenPopup("##all looks");
  }
  markItem("favourite.more");
  tooltip("All camera looks; stars make favourites.");
  if (!ImGui::BeginPopup("##all looks")) return;
  hint("Camera looks");
  if (drawLookLines(studio)) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

/// Puts things into lines, one after the other, with room for one more behind them.
class ChipLines {
 public:
  /// `used`: of the first line.
  explicit ChipLines(float used)
      : m_x(used), m_room(ImGui::GetContentRegionAvail().x), m_end(px(kMoreWidth + kChipGap)) {}

  /// Goes to where something of this width goes; false where there is no room.
  bool take(float width) {
    const float end = m_x + px(kChipGap) + width;
    if (end + (m_line == kChipLines ? m_end : 0) <= m_room) {
      ImGui::SameLine(0, px(kChipGap));
      m_x = end;
      return true;
    }
    if (m_line == kChipLines) return false;
    ++m_line;
    m_x = width;
    return true;
  }
  /// The same for what stands behind all.
  void takeEnd() const {
    if (m_x + m_end <= m_room) ImGui::SameLine(0, px(kChipGap));
  }

 private:
  float m_x, m_room, m_end;
  int m_line = 1;
};

}  // namespace

void drawFavouriteRow(const LookChoice& studio) {
  ImGui::PushFont(fonts().small);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(2), px(2)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(kChipGap), px(3)));
  ImGui::AlignTextToFramePadding();
  hint("Scene");
  tooltip("Camera looks for a kind of scene, and your own with a star: what the picture is seen through.");
  ChipLines lines(ImGui::GetItemRectSize().x);
  const std::string current = studio.editor.document().cameraLook.name;
  for (const FilterPipeline* look : studio.shelf.favourites()) {
    if (!lines.take(widthOf(*look))) break;
    if (lookChip(*look, current == look->name)) toggleCameraLook(studio.editor, studio.shelf, *look);
  }
  if (const std::string problem = studio.shelf.takeProblem(); !problem.empty()) studio.messages.warn(problem);
  lines.takeEnd();
  moreLooks(studio);
  ImGui::PopStyleVar(2);
  ImGui::PopFont();
}

}  // namespace swaplight
