#include "ui/tools/pick_tool.h"

#include <numeric>

#include "core/relight/rig_edit.h"
#include "ui/control/light_edit.h"
#include "ui/tools/pointer.h"

namespace swaplight {
namespace {

constexpr Tool kNeutral{"light.neutral", "Neutralise a pixel", "N",
                        "Click in the picture: the selected lights change colour until that pixel is grey."};
constexpr Tool kMatch{
    "light.match", "Match a pixel's colour", "",
    "Click in the picture: the selected lights take that pixel's colour. Also Alt + click."};

ToolInHand toolNow(const EditingContext& studio, const ToolInput& input) {
  return input.alt ? &kMatch : studio.tool;
}

void pickPixel(EditingContext& studio, ToolInHand tool, int x, int y) {
  const OpenSet* set = studio.set();
  if (!set || studio.document().rig.lights.empty()) return;
  const std::string& colorSpace = set->solved().colorSpace();
  const PixelShares shares = pixelShares(set->solved(), x, y);
  const size_t light = shownLight(studio);
  const Rig& rig = studio.document().rig;
  const ColorConfig& config = *studio.colors.config();
  if (tool == &kNeutral) {
    if (const auto neutral = neutralizePixel(config, rig, shares, lightsFor(studio, light), colorSpace))
      editRig(studio, "Neutralise a pixel", *neutral);
    else
      studio.messages.warn(rig.lights[light].title() + " does not reach this pixel.");
  } else if (tool == &kMatch) {
    const std::vector<Rgb> given = relitShares(config, rig, shares, colorSpace);
    const LightColor color =
        lightColorOfPixel(config, std::accumulate(given.begin(), given.end(), Rgb(0)), colorSpace);
    editLights(studio, light, "match a pixel", [&](LightSetting& setting) { setting.color = color; });
  }
}

bool wantsPick(const EditingContext& studio, const ToolInput& input) {
  const ToolInHand tool = toolNow(studio, input);
  return tool == &kNeutral || tool == &kMatch;
}

bool handlePick(EditingContext& studio, const ToolInput& input) {
  if (!input.hovered || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return true;
  if (const auto pixel = pixelUnder(studio, input.window, input.origin))
    pickPixel(studio, toolNow(studio, input), pixel->x, pixel->y);
  return true;
}

}  // namespace

const PictureTool kPickTool = {{&kNeutral, &kMatch}, wantsPick, handlePick, nullptr, ImGuiMouseCursor_Hand};

}  // namespace swaplight
