#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/color/srgb.h"
#include "core/view/probe.h"
#include "core/view/subject_image.h"
#include "ui/control/viewer_request.h"
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

/// The mean of a picture about a pixel: what the square of the probe shows under a camera look.
Rgb meanAbout(ImageView image, int x, int y, int side) {
  const int low = (side - 1) / 2;
  Rgb sum(0);
  float count = 0;
  for (int row = std::max(0, y - low); row < std::min(image.height, y - low + side); ++row)
    for (int column = std::max(0, x - low); column < std::min(image.width, x - low + side); ++column) {
      sum += Rgb(image.at(0, column, row), image.at(1, column, row), image.at(2, column, row));
      ++count;
    }
  return sum / std::max(count, 1.0F);
}

/// What the camera look has made of the place, where there is one; codes in the place of the probe's.
std::optional<Rgb> seenAt(const ViewerContext& studio, int x, int y, const DisplayTable& table,
                          std::array<uint8_t, 3>& code) {
  const auto seen = seenNow(studio);
  if (!seen) return std::nullopt;
  const auto onSeen = [&](int at) { return static_cast<int>((static_cast<float>(at) + 0.5F) * seen->scale); };
  const int side = std::max(1, onSeen(studio.view.probeSide));
  const Rgb mean = meanAbout(seen->image.view(), onSeen(x), onSeen(y), side);
  if (seen->colorSpace.empty()) {
    for (int c = 0; c < 3; ++c)
      code[static_cast<size_t>(c)] = static_cast<uint8_t>(std::lround(255 * std::clamp(mean[c], 0.0F, 1.0F)));
    return linearFromSrgb(mean);
  }
  std::array<uint8_t, 4> shown{};
  table.apply(&mean.r, &mean.g, &mean.b, 1, shown.data());
  std::copy_n(shown.begin(), 3, code.begin());
  return mean;
}

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
  PixelProbe probe = probePixels(*studio.colors.config(), set, document.rig, pixel->x, pixel->y,
                                 studio.view.probeSide, *table, studio.table.luminanceWeights());
  const std::optional<Rgb> seen = seenAt(studio, pixel->x, pixel->y, *table, probe.code);
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
    if (seen)
      ImGui::Text("seen    %.4f  %.4f  %.4f", static_cast<double>(seen->r), static_cast<double>(seen->g),
                  static_cast<double>(seen->b));
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
