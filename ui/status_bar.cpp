#include "ui/status_bar.h"

#include <fmt/core.h>
#include <imgui.h>

#include "ui/layout_probe.h"
#include "ui/theme.h"

namespace swaplight {
namespace {

std::string setText(const StudioContext& studio) {
  const OpenSet* set = studio.set();
  if (!set) return studio.session.hasDocument() ? "The pictures are not loaded." : "";
  return fmt::format("{}   {} × {}   {} lights", set->solved->capture.name, set->pictures->width(),
                     set->pictures->height(), set->solved->lightCount());
}

}  // namespace

void drawStatusBar(StudioContext& studio) {
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, kFaint);
  ImGui::TextUnformatted(setText(studio).c_str());
  const ShownPicture& shown = studio.shown;
  if (shown.valid) {
    const std::string zoom = fmt::format("{:.0f} %", 100 * shown.window.zoom);
    const float width = ImGui::CalcTextSize(zoom.c_str()).x;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width - px(4));
    ImGui::TextUnformatted(zoom.c_str());
  }
  ImGui::PopStyleColor();
}

void drawProgress(StudioContext& studio, float centerX, float centerY) {
  if (!studio.sets.busy()) return;
  ImGui::SetNextWindowPos(ImVec2(centerX, centerY), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSize(ImVec2(px(380), 0));
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing;
  if (ImGui::Begin("##progress", nullptr, flags)) {
    ImGui::PushFont(fonts().strong);
    ImGui::Text("Opening %s", studio.sets.loading().filename().c_str());
    ImGui::PopFont();
    const std::string what = studio.sets.what();
    ImGui::ProgressBar(studio.sets.fraction(), ImVec2(-1, px(8)), "");
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", studio.sets.cancelling() ? "stopping …" : what.c_str());
    ImGui::SameLine(ImGui::GetContentRegionMax().x - px(90));
    if (ImGui::Button("Cancel", ImVec2(px(90), 0))) studio.sets.cancel();
    markItem("progress.cancel");
  }
  ImGui::End();
}

}  // namespace swaplight
