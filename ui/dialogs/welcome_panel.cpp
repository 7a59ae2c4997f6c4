#include "ui/dialogs/welcome_panel.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>

#include "core/file/user_folders.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace fs = std::filesystem;
namespace {

constexpr size_t kRecentShown = 5;

std::string homely(const fs::path& path) {
  const std::string home = homeFolder().string();
  const std::string text = path.string();
  return home.size() > 1 && text.starts_with(home) ? fmt::format("~{}", text.substr(home.size())) : text;
}

bool wideButton(const char* icon, const std::string& text, float width) {
  ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, ImVec2(0, 0.5F));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(14), px(10)));
  const bool clicked = ImGui::Button(fmt::format("{}   {}", icon, text).c_str(), ImVec2(width, 0));
  ImGui::PopStyleVar(2);
  return clicked;
}

void recentList(SessionController& session, float width) {
  const std::vector<fs::path>& files = session.recent().files();
  if (files.empty()) return;
  ImGui::Dummy(ImVec2(0, px(10)));
  hint("Recent");
  fs::path chosen;
  for (size_t i = 0; i < std::min(files.size(), kRecentShown); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable(homely(files[i]).c_str(), false, 0, ImVec2(width, 0))) chosen = files[i];
    ImGui::PopID();
  }
  if (!chosen.empty()) session.open(chosen);
}

}  // namespace

void drawWelcomePanel(SessionController& session, const ActionTable& actions,
                      const std::vector<fs::path>& samples) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, ImVec2(at.x + room.x, at.y + room.y), kViewerGround);
  const float width = std::min(px(440), room.x - px(40));
  const float lines = static_cast<float>(std::min(session.recent().files().size(), kRecentShown));
  const float height = px(260) + 3 * px(46) + lines * px(26);
  ImGui::SetCursorPos(ImVec2((room.x - width) / 2, std::max(px(20), (room.y - height) / 2)));
  ImGui::BeginGroup();
  ImGui::PushFont(fonts().title);
  ImGui::TextUnformatted("Swaplight");
  ImGui::PopFont();
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
  ImGui::TextDisabled(
      "Photograph a set while its lights change colour. Swaplight separates the lights, and you relight the "
      "set.");
  ImGui::PopTextWrapPos();
  ImGui::Dummy(ImVec2(0, px(12)));
  if (wideButton(kIconOpen, "Open a capture, a solved set or a session …", width)) actions.run("file.open");
  markItem("welcome.open");
  if (wideButton(kIconPhoto, "Import your own photographs …", width)) actions.run("file.new");
  markItem("welcome.new");
  for (const fs::path& sample : samples) {
    const std::string name = sample.parent_path().filename().string();
    ImGui::PushID(name.c_str());
    if (wideButton(kIconImage, "Try the sample: " + name, width)) session.open(sample);
    ImGui::PopID();
    markItem({"welcome.sample.", name});
  }
  ImGui::Dummy(ImVec2(0, px(2)));
  hint("Or drop a file or folder here.");
  recentList(session, width);
  ImGui::EndGroup();
}

}  // namespace swaplight
