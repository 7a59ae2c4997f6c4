#include "ui/kit/command_palette.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr int kRows = 12;

bool pressed(ImGuiKey key) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

/// One action with its keys at the right. True when clicked.
bool line(const Action& action, bool chosen) {
  if (!action.isEnabled()) ImGui::PushStyleColor(ImGuiCol_Text, kFaint);
  const bool clicked = ImGui::Selectable((action.name + "##" + action.id).c_str(), chosen);
  markItem({"palette.", action.id});
  if (!action.isEnabled()) ImGui::PopStyleColor();
  if (chosen) ImGui::SetScrollHereY();
  const float width = ImGui::CalcTextSize(action.keys.c_str()).x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width - px(8));
  ImGui::TextDisabled("%s", action.keys.c_str());
  return clicked;
}

}  // namespace

void CommandPalette::draw(const ActionTable& actions) {
  if (std::exchange(m_opening, false)) {
    ImGui::OpenPopup("##palette");
    m_filter.clear();
    m_chosen = 0;
  }
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y * 0.12F), ImGuiCond_Always, ImVec2(0.5F, 0));
  ImGui::SetNextWindowSize(ImVec2(std::min(px(560), screen.x * 0.9F), 0));
  m_open = ImGui::BeginPopup("##palette");
  if (!m_open) return;
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  // The arrows move through the list, and stay in the field.
  const auto nothing = [](ImGuiInputTextCallbackData*) { return 0; };
  if (ImGui::InputTextWithHint("##filter", "Find an action", &m_filter, ImGuiInputTextFlags_CallbackHistory,
                               nothing))
    m_chosen = 0;
  markItem("palette.filter");

  // What is called so comes before what only speaks of it.
  std::vector<const Action*> found, described;
  for (const Action& action : actions.actions()) {
    if (matchesWords(action.name + " " + action.id, m_filter))
      found.push_back(&action);
    else if (matchesWords(action.tooltip, m_filter))
      described.push_back(&action);
  }
  found.insert(found.end(), described.begin(), described.end());
  const int last = static_cast<int>(found.size()) - 1;
  if (pressed(ImGuiKey_DownArrow)) ++m_chosen;
  if (pressed(ImGuiKey_UpArrow)) --m_chosen;
  m_chosen = std::clamp(m_chosen, 0, std::max(0, last));
  const Action* run = pressed(ImGuiKey_Enter) && last >= 0 ? found[static_cast<size_t>(m_chosen)] : nullptr;

  ImGui::BeginChild("##found", ImVec2(0, kRows * ImGui::GetTextLineHeightWithSpacing()));
  for (int i = 0; i <= last; ++i)
    if (line(*found[static_cast<size_t>(i)], i == m_chosen)) run = found[static_cast<size_t>(i)];
  if (found.empty()) hint("No matching action.");
  ImGui::EndChild();
  if (run && run->isEnabled()) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  if (run && run->isEnabled()) run->run();
}

}  // namespace swaplight
