#include "ui/kit/action_widgets.h"

#include <imgui.h>

#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {

void actionMenuItem(const ActionTable& actions, const std::string& id) {
  const Action* action = actions.find(id);
  if (!action) return;
  if (ImGui::MenuItem(action->name.c_str(), action->firstKeys().c_str(), action->isChecked(),
                      action->isEnabled()))
    action->run();
  markItem({"menu.", id});
  tooltip(action->tooltip.c_str());
}

std::string actionTip(const Action& action) {
  const std::string keys = action.firstKeys();
  return action.name + (keys.empty() ? "" : "  (" + keys + ")") + "\n" + action.tooltip;
}

void actionTextButton(const ActionTable& actions, const std::string& id, const char* text, float width) {
  const Action* action = actions.find(id);
  if (!action) return;
  ImGui::BeginDisabled(!action->isEnabled());
  pushChosen(action->isChecked());
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(2), ImGui::GetStyle().FramePadding.y));
  ImGui::PushID(id.c_str());  // other buttons may have the same words
  const bool clicked = ImGui::Button(text, ImVec2(width, 0));
  ImGui::PopID();
  ImGui::PopStyleVar();
  popChosen();
  markItem({"button.", id});
  tooltip(actionTip(*action).c_str());
  ImGui::EndDisabled();
  if (clicked) action->run();
}

bool actionButton(const ActionTable& actions, const std::string& id, const char* icon, float side) {
  const Action* action = actions.find(id);
  if (!action) return false;
  ImGui::BeginDisabled(!action->isEnabled());
  ImGui::PushID(id.c_str());
  const bool clicked = toggleButton(icon, action->isChecked(), kAccent, side, actionTip(*action).c_str());
  markItem({"button.", id});
  ImGui::PopID();
  ImGui::EndDisabled();
  if (clicked) action->run();
  return clicked;
}

}  // namespace swaplight
