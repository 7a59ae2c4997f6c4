#include "ui/viewer/which_light.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

#include "core/view/probe.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/light_words.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/tools/pointer.h"
#include "ui/viewer/share_bar.h"

namespace swaplight {
namespace {

constexpr float kFromMouse = 20;
constexpr float kLeastShare = 0.005F;  // what a click can select: below, the bar shows nothing

/// The lights of a pixel, brightest first, with their shares of its luminance.
struct PixelLights {
  PicturePixel pixel;
  std::vector<float> shares;  ///< by light, ambient last
  std::vector<size_t> order;
};

std::optional<PixelLights> lightsOf(const ViewerContext& studio, const std::optional<PicturePixel>& pixel) {
  if (!pixel) return std::nullopt;
  const SolvedSet& set = studio.set()->solved();
  const Document& document = studio.document();
  const auto table = studio.table.table(studio.colors.config(), set.colorSpace(), document.display);
  PixelLights found{*pixel, {}, std::vector<size_t>(document.rig.lights.size())};
  found.shares = probePixels(*studio.colors.config(), set, document.rig, pixel->x, pixel->y,
                             studio.view.probeSide, *table, studio.table.luminanceWeights())
                     .shares;
  std::iota(found.order.begin(), found.order.end(), size_t{0});
  std::stable_sort(found.order.begin(), found.order.end(),
                   [&](size_t a, size_t b) { return found.shares[a] > found.shares[b]; });
  return found;
}

/// How often the pixel has been clicked since another one was.
size_t clicksOn(const ViewerContext& studio, const PicturePixel& pixel) {
  const ViewerState::LightAsked& last = studio.viewer.lightAsked;
  return last.x == pixel.x && last.y == pixel.y ? last.clicks : 0;
}

/// The light that a click selects; nothing where none of them shines on the pixel.
std::optional<size_t> lightOfClick(const ViewerContext& studio, const PixelLights& found) {
  const auto giving = static_cast<size_t>(std::count_if(
      found.order.begin(), found.order.end(), [&](size_t i) { return found.shares[i] >= kLeastShare; }));
  if (giving == 0) return std::nullopt;
  return found.order[clicksOn(studio, found.pixel) % giving];
}

}  // namespace

bool asksWhichLight(const ViewerContext& studio) {
  return studio.keyboard.isHeld("Q") && !ImGui::GetIO().WantTextInput && studio.set() &&
         !studio.document().rig.lights.empty();
}

void selectLightOf(ViewerContext& studio, const std::optional<PicturePixel>& pixel) {
  const auto found = lightsOf(studio, pixel);
  if (!found) return;
  const auto light = lightOfClick(studio, *found);
  studio.viewer.lightAsked = {found->pixel.x, found->pixel.y, clicksOn(studio, found->pixel) + 1};
  if (!light) return;
  studio.view.selectedLights.clear();
  studio.view.selectedLight = static_cast<int>(*light);
}

void drawWhichLight(ViewerContext& studio, ImVec2 origin, ImVec2 size) {
  if (!asksWhichLight(studio)) return;
  const auto found = lightsOf(studio, pixelAtMouse(studio));
  if (!found) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool left = mouse.x > origin.x + size.x - px(kSharesWidth + 2 * kFromMouse);
  const bool above = mouse.y > origin.y + 0.6F * size.y;
  ImGui::SetNextWindowPos(
      ImVec2(mouse.x + px(left ? -kFromMouse : kFromMouse), mouse.y + px(above ? -kFromMouse : kFromMouse)),
      ImGuiCond_Always, ImVec2(left ? 1 : 0, above ? 1 : 0));
  ImGui::SetNextWindowSize(ImVec2(px(kSharesWidth), 0));
  ImGui::SetNextWindowBgAlpha(0.9F);
  if (ImGui::Begin("##which light", nullptr, kCardFlags)) {
    ImGui::PushFont(fonts().small);
    const std::vector<LightSetting>& lights = studio.document().rig.lights;
    const auto taken = lightOfClick(studio, *found);
    for (const size_t i : found->order)
      drawShareBar(lights[i].title(), found->shares[i], chipColor(lights[i].color), taken == i);
    if (studio.set()->solved().ambient) drawShareBar("ambient", found->shares.back(), Rgb(0.6F));
    ImGui::TextDisabled("%s", taken ? fmt::format("Click: select {}", lights[*taken].title()).c_str()
                                    : "No light shines here.");
    ImGui::PopFont();
    const ImVec2 low = ImGui::GetWindowPos(), extent = ImGui::GetWindowSize();
    markRect("viewer.which_light", low.x, low.y, low.x + extent.x, low.y + extent.y);
    markState("viewer.which_light", taken ? lights[*taken].light : "none");
  }
  ImGui::End();
}

}  // namespace swaplight
