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
#include "ui/viewer/viewer_overlay.h"

namespace swaplight {
namespace {

constexpr float kWidth = 250;
constexpr float kCardMargin = 12;

std::string stopsWords(float stops) {
  return std::isfinite(stops) ? fmt::format("{:+.2f} st from grey", stops) : "black";
}

void shareBar(const std::string& name, float share, const Rgb& color) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float row = ImGui::GetTextLineHeight() + px(4);
  const float left = px(76), right = px(48);
  const float room = px(kWidth) - 2 * px(10) - left - right;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->PushClipRect(at, ImVec2(at.x + left - px(4), at.y + row), true);
  draw->AddText(at, kText, name.c_str());
  draw->PopClipRect();
  const ImVec2 low(at.x + left, at.y + px(3));
  draw->AddRectFilled(low, ImVec2(low.x + room, low.y + row - px(8)), IM_COL32(70, 70, 70, 255), px(2));
  draw->AddRectFilled(low, ImVec2(low.x + room * share, low.y + row - px(8)), colorU32(color), px(2));
  const std::string number = fmt::format("{:.1f} %", 100 * share);
  draw->AddText(ImVec2(at.x + px(kWidth) - 2 * px(10) - ImGui::CalcTextSize(number.c_str()).x, at.y), kText,
                number.c_str());
  ImGui::Dummy(ImVec2(px(kWidth) - 2 * px(10), row));
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
  const bool right = ImGui::GetIO().MousePos.x < origin.x + size.x - px(kWidth + 3 * kCardMargin);
  ImGui::SetNextWindowPos(ImVec2(right ? origin.x + size.x - px(kCardMargin) : origin.x + px(kCardMargin),
                                 origin.y + size.y - px(kCardMargin) - px(right ? 0 : kCardMargin + 30)),
                          ImGuiCond_Always, ImVec2(right ? 1 : 0, 1));
  ImGui::SetNextWindowSize(ImVec2(px(kWidth), 0));
  ImGui::SetNextWindowBgAlpha(0.85F);
  if (ImGui::Begin("##probe", nullptr,
                   ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                       ImGuiWindowFlags_AlwaysAutoResize)) {
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
      shareBar(document.rig.lights[i].title(), probe.shares[i], chipColor(document.rig.lights[i].color));
    if (set.ambient) shareBar("ambient", probe.shares.back(), Rgb(0.6F));
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
