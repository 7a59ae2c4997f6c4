#include "ui/dialogs/about_box.h"

#include <imgui.h>
#include <algorithm>

#include "core/base/version.h"
#include "core/file/user_folders.h"
#include "core/ocio/color_config.h"
#include "render/gl/gl_info.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

void row(const char* name, const std::string& value) {
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", name);
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", value.c_str());
}

}  // namespace

void drawAboutBox(const std::string& engine, const ColorConfig& config, bool* open) {
  if (!*open) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSize(ImVec2(std::min(px(620), screen.x - px(40)), 0));
  if (ImGui::Begin("About", open,
                   ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                       ImGuiWindowFlags_NoSavedSettings)) {
    ImGui::PushFont(fonts().title);
    ImGui::TextUnformatted("Swaplight");
    ImGui::PopFont();
    ImGui::TextWrapped("Relight a photographed set.");
    ImGui::Dummy(ImVec2(0, px(8)));
    if (ImGui::BeginTable("##facts", 2)) {
      ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, px(130));
      ImGui::TableSetupColumn("value");
      row("Version", version());
      row("Render engine", engine);
      row("OpenGL", glInfo().renderer);
      row("Colour", config.name());
      row("Keys", (configFolder() / "keys.txt").string());
      row("Recovery", (stateFolder() / "recovery").string());
      row("Made with",
          "Dear ImGui, GLFW, OpenColorIO, OpenImageIO, OpenEXR, OpenCV, Eigen, oneTBB, {fmt}, "
          "JSON for Modern C++, GLM, Inter, Material Icons");
      ImGui::EndTable();
    }
    ImGui::Dummy(ImVec2(0, px(4)));
    hint("To change the engine, start with swaplight studio --engine graphics or --engine processor.");
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    markRect("about", low.x, low.y, low.x + size.x, low.y + size.y);
  }
  ImGui::End();
}

}  // namespace swaplight
