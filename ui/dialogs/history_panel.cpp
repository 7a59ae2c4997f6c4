#include "ui/dialogs/history_panel.h"

#include <imgui.h>

#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"

namespace swaplight {

void drawHistoryPanel(DocumentEditor& editor, bool* open) {
  if (!*open) return;
  ImGui::SetNextWindowPos(ImVec2(px(64), px(80)), ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize(ImVec2(px(300), px(360)), ImGuiCond_FirstUseEver);
  if (ImGui::Begin("History", open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
    const History& history = editor.history();
    size_t chosen = history.position();
    for (size_t i = 0; i < history.steps().size(); ++i) {
      const bool undone = i > history.position();
      ImGui::PushID(static_cast<int>(i));
      if (undone) ImGui::PushStyleColor(ImGuiCol_Text, kFaint);
      if (ImGui::Selectable(history.steps()[i].name.c_str(), i == history.position())) chosen = i;
      if (undone) ImGui::PopStyleColor();
      ImGui::PopID();
      markItem({"history.", i});
    }
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    markRect("history", low.x, low.y, low.x + size.x, low.y + size.y);
    if (chosen != history.position()) {
      editor.commit();
      editor.goTo(chosen);
    }
  }
  ImGui::End();
}

}  // namespace swaplight
