#include "ui/shell/progress_boxes.h"

#include <imgui.h>

#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"

namespace swaplight {

void drawSetProgress(SetController& sets, float centerX, float centerY) {
  if (!sets.busy()) return;
  ImGui::SetNextWindowPos(ImVec2(centerX, centerY), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSize(ImVec2(px(380), 0));
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing;
  if (ImGui::Begin("##progress", nullptr, flags)) {
    ImGui::PushFont(fonts().strong);
    ImGui::TextUnformatted(sets.task().c_str());
    ImGui::PopFont();
    const std::string what = sets.what();
    ImGui::ProgressBar(sets.fraction(), ImVec2(-1, px(8)), "");
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", sets.cancelling() ? "stopping …" : what.c_str());
    ImGui::SameLine(ImGui::GetContentRegionMax().x - px(90));
    if (ImGui::Button("Cancel", ImVec2(px(90), 0))) sets.cancel();
    markItem("progress.cancel");
  }
  ImGui::End();
}

void drawExportProgress(ExportController& exports, float right, float bottom) {
  if (!exports.busy()) return;
  ImGui::SetNextWindowPos(ImVec2(right, bottom), ImGuiCond_Always, ImVec2(1, 1));
  ImGui::SetNextWindowSize(ImVec2(px(320), 0));
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing;
  if (ImGui::Begin("##exporting", nullptr, flags)) {
    ImGui::Text("Exporting %s", exports.name().c_str());
    ImGui::ProgressBar(exports.fraction(), ImVec2(-1, px(8)), "");
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", exports.cancelling() ? "stopping \u2026" : exports.what().c_str());
    ImGui::SameLine(ImGui::GetContentRegionMax().x - px(90));
    if (ImGui::Button("Cancel", ImVec2(px(90), 0))) exports.cancel();
    markItem("exporting.cancel");
  }
  ImGui::End();
}

}  // namespace swaplight
