#include "ui/shell/toolbar.h"

#include <imgui.h>

#include <array>
#include <cmath>

#include "ui/kit/action_widgets.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kSide = 34;
constexpr float kGap = 4;
constexpr float kGroupGap = 8;  ///< more of it before a group

struct ToolButton {
  const char* id;  ///< of its action
  const char* icon;
  bool begins = false;  ///< a group
};
constexpr std::array<ToolButton, 16> kButtons = {{{"file.open", kIconOpen},
                                                  {"file.save", kIconSave},
                                                  {"file.export", kIconExport},
                                                  {"edit.undo", kIconUndo, true},
                                                  {"edit.redo", kIconRedo},
                                                  {"edit.history", kIconHistory},
                                                  {"view.fit", kIconFit, true},
                                                  {"view.one_to_one", "1:1"},
                                                  {"brush.take", kIconBrush, true},
                                                  {"light.neutral", kIconPicker},
                                                  {"view.probe", kIconInfo},
                                                  {"compare.wipe", kIconCompare},
                                                  {"view.photograph", kIconPhoto},
                                                  {"view.scopes", kIconScopes},
                                                  {"view.gallery", kIconGallery},
                                                  {"help.keys", kIconHelp, true}}};

/// Pixels from the first button's upper edge to the lower one of the button, or of "more" in its place.
float lowerEdge(size_t index) {
  float at = px(kSide);
  for (size_t i = 1; i <= index; ++i)
    at += px(kSide) + px(kGap) + (i < kButtons.size() && kButtons[i].begins ? px(kGroupGap) : 0);
  return at;
}

size_t buttonsThatFit(float room) {
  if (lowerEdge(kButtons.size() - 1) <= room) return kButtons.size();
  size_t count = 0;
  while (count + 1 < kButtons.size() && lowerEdge(count + 1) <= room) ++count;
  return count;
}

}  // namespace

void drawToolbar(const ActionTable& actions) {
  const size_t count = buttonsThatFit(ImGui::GetContentRegionAvail().y);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(kGap), px(kGap)));
  for (size_t i = 0; i < count; ++i) {
    if (kButtons[i].begins) ImGui::SetCursorPosY(ImGui::GetCursorPosY() + px(kGroupGap));
    actionButton(actions, kButtons[i].id, kButtons[i].icon, px(kSide));
  }
  bool open = false;
  if (count < kButtons.size()) {
    open = toggleButton(kIconMore, false, kAccent, px(kSide), "More tools");
    markItem("button.more_tools");
  }
  const ImVec2 beside(ImGui::GetItemRectMax().x + px(kGap), ImGui::GetItemRectMax().y);
  ImGui::PopStyleVar();
  if (open) ImGui::OpenPopup("##more tools");
  ImGui::SetNextWindowPos(beside, ImGuiCond_Always, ImVec2(0, 1));
  if (!ImGui::BeginPopup("##more tools")) return;
  for (size_t i = count; i < kButtons.size(); ++i) {
    if (kButtons[i].begins && i > count) ImGui::Separator();
    actionMenuItem(actions, kButtons[i].id);
  }
  ImGui::EndPopup();
}

}  // namespace swaplight
