#include "ui/shell/message_list.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <string>

#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"

namespace swaplight {
namespace {

const char* iconOf(Messages::Kind kind) {
  if (kind == Messages::Kind::Error) return kIconError;
  return kind == Messages::Kind::Warning ? kIconWarning : kIconInfo;
}

ImU32 colorOf(Messages::Kind kind) {
  if (kind == Messages::Kind::Error) return kMute;
  return kind == Messages::Kind::Warning ? kChanged : kAccent;
}

}  // namespace

void drawMessages(Messages& messages, float left, float bottom, float maxWidth) {
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  size_t dismissed = messages.messages().size();
  for (size_t i = messages.messages().size(); i-- > 0;) {
    const Messages::Message& message = messages.messages()[i];
    ImGui::SetNextWindowPos(ImVec2(left, bottom), ImGuiCond_Always, ImVec2(0, 1));
    ImGui::PushStyleColor(ImGuiCol_Border, colorOf(message.kind));
    const std::string window = "##message" + std::to_string(i);
    if (ImGui::Begin(window.c_str(), nullptr, flags)) {
      ImGui::PushStyleColor(ImGuiCol_Text, colorOf(message.kind));
      ImGui::TextUnformatted(iconOf(message.kind));
      ImGui::PopStyleColor();
      ImGui::SameLine();
      ImGui::PushTextWrapPos(maxWidth);
      ImGui::TextUnformatted(message.text.c_str());
      ImGui::PopTextWrapPos();
      // Above the panels, but not above a menu that is open.
      if (!ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup))
        ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
      if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0)) dismissed = i;
      const ImVec2 at = ImGui::GetWindowPos();
      const ImVec2 size = ImGui::GetWindowSize();
      markRect({"message.", i}, at.x, at.y, at.x + size.x, at.y + size.y);
      bottom = at.y - px(6);
    }
    ImGui::End();
    ImGui::PopStyleColor();
  }
  if (dismissed < messages.messages().size()) messages.dismiss(dismissed);
}

}  // namespace swaplight
