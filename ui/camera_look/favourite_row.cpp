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

constexpr float kChipGap = 4, kChipPadding = 6, kMoreWidth = 22, kMostChip = 170;
constexpr float kTwoLinesHeight = 800;  ///< of the window: in a lower one the room belongs to the lights

std::string tipOf(const FilterPipeline& look, bool on) {
  std::vector<std::string> filters;
  for (const FilterStage& stage : look.stages) filters.push_back(stage.filter);
  return fmt::format("{}\n{}", fmt::join(filters, ", "),
                     on ? "Click for the plain picture. F10 shows the filters."
                        : "Click to see the picture through this camera look.");
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
  explicit ChipLines(int most)
      : m_most(most), m_room(ImGui::GetContentRegionAvail().x), m_end(px(kMoreWidth + kChipGap)) {}

  /// Goes to where something of this width goes; false where there is no room.
  bool take(float width) {
    const float begin = m_x > 0 ? m_x + px(kChipGap) : 0;
    if (begin + width + (m_line == m_most ? m_end : 0) <= m_room) {
      if (m_x > 0) ImGui::SameLine(0, px(kChipGap));
      m_x = begin + width;
      return true;
    }
    if (m_line == m_most) return false;
    ++m_line;
    m_x = width;
    return true;
  }
  /// The same for what stands behind all.
  void takeEnd() const {
    if (m_x > 0 && m_x + m_end <= m_room) ImGui::SameLine(0, px(kChipGap));
  }

 private:
  int m_most, m_line = 1;
  float m_x = 0, m_room, m_end;
};

}  // namespace

void drawFavouriteRow(const LookChoice& studio) {
  ImGui::PushFont(fonts().small);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(2), px(2)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(kChipGap), px(3)));
  ChipLines lines(ImGui::GetIO().DisplaySize.y < px(kTwoLinesHeight) ? 1 : 2);
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
