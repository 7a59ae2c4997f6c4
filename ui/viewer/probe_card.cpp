#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/view/probe.h"
#include "core/view/subject_image.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/light_words.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/tools/pointer.h"
#include "ui/viewer/share_bar.h"
#include "ui/viewer/viewer_overlay.h"

namespace swaplight {
namespace {

constexpr float kCardMargin = 12;

std::string stopsWords(float stops) {
  return std::isfinite(stops) ? fmt::format("{:+.2f} st from grey", stops) : "black";
}

}  // namespace

void drawProbeCard(ViewerContext& studio, ImVec2 origin, ImVec2 size) {
  if (!studio.view.probe) return;
  const auto pixel = pixelAtMouse(studio);
  if (!pixel) return;
  const SolvedSet& set = studio.set()->solved();
  const Document& document = studio.document();
  const auto table = studio.table.table(studio.colors.config(), set.colorSpace(), document.display);
  const PixelProbe probe = probePixels(*studio.colors.config(), set, document.rig, pixel->x, pixel->y,
                                       studio.view.probeSide, *table, studio.table.luminanceWeights());
  // At the right, unless the mouse is there.
  const bool right = ImGui::GetIO().MousePos.x < origin.x + size.x - px(kSharesWidth + 3 * kCardMargin);
  ImGui::SetNextWindowPos(ImVec2(right ? origin.x + size.x - px(kCardMargin) : origin.x + px(kCardMargin),
                                 origin.y + size.y - px(kCardMargin) - px(right ? 0 : kCardMargin + 30)),
                          ImGuiCond_Always, ImVec2(right ? 1 : 0, 1));
  ImGui::SetNextWindowSize(ImVec2(px(kSharesWidth), 0));
  ImGui::SetNextWindowBgAlpha(0.85F);
  if (ImGui::Begin("##probe", nullptr, kCardFlags)) {
    ImGui::PushFont(fonts().small);
    const Rgb& v = probe.linear;
    ImGui::TextDisabled("%s", fmt::format("x {}  y {}   {} \u00d7 {}", pixel->x, pixel->y,
                                          studio.view.probeSide, studio.view.probeSide)
                                  .c_str());
    ImGui::Text("linear  %.4f  %.4f  %.4f", static_cast<double>(v.r), static_cast<double>(v.g),
                static_cast<double>(v.b));
    ImGui::Text("code  %d  %d  %d     %s", probe.code[0], probe.code[1], probe.code[2],
                stopsWords(probe.stops).c_str());
    ImGui::Separator();
    for (size_t i = 0; i < document.rig.lights.size(); ++i)
      drawShareBar(document.rig.lights[i].title(), probe.shares[i], chipColor(document.rig.lights[i].color));
    if (set.ambient) drawShareBar("ambient", probe.shares.back(), Rgb(0.6F));
    const std::string flags = flagWords(probe.flags);
    ImGui::TextDisabled("%s", fmt::format("residual {:.2f}   error {:.1f} %{}{}", probe.residual,
                                          100 * probe.sigma, flags.empty() ? "" : "   ", flags)
                                  .c_str());
    ImGui::PopFont();
    markState("probe",
              fmt::format("{} {} {} {} {}", pixel->x, pixel->y, probe.code[0], probe.code[1], probe.code[2]));
    const ImVec2 low = ImGui::GetWindowPos(), extent = ImGui::GetWindowSize();
    markRect("viewer.probe", low.x, low.y, low.x + extent.x, low.y + extent.y);
  }
  ImGui::End();
}

}  // namespace swaplight
