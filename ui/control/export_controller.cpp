#include "ui/control/export_controller.h"

#include <imgui.h>

#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"

namespace swaplight {

void ExportController::start(std::shared_ptr<const SolvedSet> set, const Document& document,
                             const ExportRequest& request) {
  m_name = request.file.filename().string();
  m_job.start([set = std::move(set), document, request](
                  const Progress& progress) { return exportDocument(set, document, request, progress); },
              m_wake);
}

void ExportController::update(Messages& messages) {
  try {
    const auto files = m_job.take();
    if (!files) return;
    std::string words = "Exported " + files->front().string();
    if (files->size() > 1) words += " and " + std::to_string(files->size() - 1) + " more";
    messages.info(words);
  } catch (const Stopped&) {
    messages.info("Export cancelled.");
  } catch (const std::bad_alloc&) {
    messages.error("There is not enough memory for this export.");
  } catch (const std::exception& error) {
    messages.error(error.what());
  }
}

void ExportController::drawProgress(float right, float bottom) {
  if (!busy()) return;
  ImGui::SetNextWindowPos(ImVec2(right, bottom), ImGuiCond_Always, ImVec2(1, 1));
  ImGui::SetNextWindowSize(ImVec2(px(320), 0));
  constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing;
  if (ImGui::Begin("##exporting", nullptr, flags)) {
    ImGui::Text("Exporting %s", m_name.c_str());
    ImGui::ProgressBar(m_job.fraction(), ImVec2(-1, px(8)), "");
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", m_job.cancelling() ? "stopping \u2026" : m_job.what().c_str());
    ImGui::SameLine(ImGui::GetContentRegionMax().x - px(90));
    if (ImGui::Button("Cancel", ImVec2(px(90), 0))) m_job.cancel();
    markItem("exporting.cancel");
  }
  ImGui::End();
}

}  // namespace swaplight
