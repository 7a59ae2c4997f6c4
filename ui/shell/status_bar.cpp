#include "ui/shell/status_bar.h"

#include <fmt/core.h>
#include <imgui.h>

#include "core/ocio/color_config.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/shell/solve_report_box.h"

namespace swaplight {
namespace {

std::string setText(const SessionController& session) {
  const OpenSet* set = session.set();
  if (!set) return session.hasDocument() ? "Pictures not loaded." : "";
  return fmt::format("{}   {} × {}   {} lights", set->solved().capture.name, set->pictures().width(),
                     set->pictures().height(), set->solved().lightCount());
}

/// The colour configuration's name, ending at `right`; in a colour of its own where another one was asked
/// for.
void drawColors(const ColorChoice& colors, float right) {
  const std::string& trouble = colors.trouble();
  const std::string words =
      "Colours: " + colors.config()->title() + (trouble.empty() ? "" : ", not the one requested");
  ImGui::SameLine(right - ImGui::CalcTextSize(words.c_str()).x);
  if (!trouble.empty()) ImGui::PushStyleColor(ImGuiCol_Text, kChanged);
  ImGui::TextUnformatted(words.c_str());
  if (!trouble.empty()) ImGui::PopStyleColor();
  markItem(trouble.empty() ? "status.colors" : "status.colors_trouble");
  tooltip(trouble.empty() ? "OpenColorIO configuration in use" : trouble.c_str());
}

}  // namespace

void drawStatusBar(const SessionController& session, const ShownPicture& shown, const ColorChoice& colors) {
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, kFaint);
  ImGui::TextUnformatted(setText(session).c_str());
  if (session.set() && session.set()->original->report) {
    ImGui::SameLine(0, px(24));
    drawSolveWord(*session.set()->original->report);
  }
  const std::string zoom = shown.valid ? fmt::format("{:.0f} %", 100 * shown.window.zoom) : "";
  const float zoomAt = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(zoom.c_str()).x - px(4);
  drawColors(colors, zoomAt - px(24));
  if (shown.valid) {
    ImGui::SameLine(zoomAt);
    ImGui::TextUnformatted(zoom.c_str());
  }
  ImGui::PopStyleColor();
}

}  // namespace swaplight
