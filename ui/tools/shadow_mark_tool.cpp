#include "ui/tools/shadow_mark_tool.h"

#include "ui/control/shadow_edit.h"
#include "ui/kit/theme.h"
#include "ui/tools/pointer.h"

namespace swaplight {
namespace {

constexpr float kMarkReach = 9;  // pixels of the screen at scale 1: so near to a mark, a click is on it

constexpr Tool kMarkShadow{
    "shadows.mark_shadow", "This is shadow", "",
    "Click in the picture: the selected light does not reach this surface. Click a label to "
    "remove it."};
constexpr Tool kMarkLit{
    "shadows.mark_lit", "This is lit", "",
    "Click in the picture: the selected light reaches this surface. Click a label to remove "
    "it."};

bool inHand(const EditingContext& studio) {
  return studio.tool == &kMarkShadow || studio.tool == &kMarkLit;
}

bool wantsMark(const EditingContext& studio, const ToolInput& input) {
  return inHand(studio) && !input.moves && !input.alt;
}

bool handleMark(EditingContext& studio, const ToolInput& input) {
  if (!input.hovered || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return true;
  const auto pixel = pixelUnder(studio, input.window, input.origin);
  const std::string light = shownShadowLight(studio);
  if (!pixel) return true;
  if (light.empty()) {
    studio.messages.info("Lights added by edits have no shadows. Select another light in the mixer.");
    return true;
  }
  const auto kind = studio.tool == &kMarkLit ? ShadowMark::Kind::Lit : ShadowMark::Kind::Shadow;
  markShadow(studio, light, {kind, pixel->x, pixel->y},
             px(kMarkReach) / static_cast<float>(input.window.zoom));
  studio.edits.findShadowsAgain();
  return true;
}

/// What is marked is to be seen: the tool brings its page.
void showPage(EditingContext& studio, const ViewWindow& /*window*/, ImVec2 /*origin*/) {
  if (inHand(studio)) studio.layout.shadows = studio.layout.edits = true;
}

}  // namespace

const PictureTool kShadowMarkTool = {
    {&kMarkShadow, &kMarkLit}, wantsMark, handleMark, showPage, ImGuiMouseCursor_Hand};

}  // namespace swaplight
