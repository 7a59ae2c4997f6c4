#include "ui/shadows/shadow_sliders.h"

#include <fmt/core.h>
#include <imgui.h>

#include <cmath>

#include "core/color/srgb.h"
#include "ui/control/shadow_edit.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/light_words.h"
#include "ui/kit/panel_controls.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

using Kind = ShadowOperation::Kind;

constexpr float kMostSoft = 256;  // pixels
constexpr float kRemoveWidth = 76, kAllWidth = 36;
const Rgb kFirstColor{0.2F, 0.35F, 1};

/// The light whose shadows are changed.
struct ShadowSliders {
  EditingContext& studio;
  const std::string& light;

  /// Edits of the shadows of a light that gives nothing now are kept, and show later.
  void sayWhatHides() const {
    const std::string words = unseenEditWords(studio.document().rig, {light}, "shadow edits");
    if (!words.empty()) studio.messages.info(words);
  }
  void preview(const char* what, const ShadowKinds& kinds, const ShadowOperation& operation) const {
    if (!studio.editor.inGesture()) sayWhatHides();
    studio.editor.preview("Shadows of " + light + ": " + what,
                          withShadowOperation(studio, light, kinds, operation));
  }
};

void removeButton(const ShadowSliders& sliders) {
  const ShadowKinds kinds = {Kind::Lighten, Kind::Deepen};
  ShadowOperation operation = shadowOperation(sliders.studio, sliders.light, kinds);
  const bool gone = operation.kind == Kind::Lighten && operation.amount == 1;
  if (ImGui::Button(gone ? "Restore" : "Remove", ImVec2(px(kRemoveWidth), 0))) {
    operation.kind = Kind::Lighten;
    operation.amount = gone ? 0 : 1;
    sliders.sayWhatHides();
    sliders.studio.editor.edit("Shadows of " + sliders.light + (gone ? ": brought back" : ": removed"),
                               withShadowOperation(sliders.studio, sliders.light, kinds, operation));
  }
  markItem("shadows.remove");
  if (gone) return tooltip("Brings the shadow back.");
  tooltip(
      "Fills the shadow with an estimate of the missing light, from its ratio to the other lights around the "
      "shadow. What lies outside a spot's cone, or beyond all that the light reaches, stays as it is: click "
      "it "
      "in the picture to fill that, too.");
}

/// Whose shadows are changed, and what does away with them.
void target(const ShadowSliders& sliders) {
  const ShadowState& state = sliders.studio.editing.shadow;
  const bool one = state.chosen && state.light == sliders.light;
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(fonts().strong);
  ImGui::TextUnformatted(one ? "This shadow" : "All shadows");
  ImGui::PopFont();
  tooltip(one ? "Changes this shadow only. Escape: all of the light's shadows."
              : "Changes all of the light's shadows. Click one in the picture to change only that one.");
  const float right = ImGui::GetContentRegionMax().x - px(kRemoveWidth);
  if (one) {
    ImGui::SameLine(right - px(kAllWidth + 4));
    if (ImGui::Button("All", ImVec2(px(kAllWidth), 0))) sliders.studio.actions.run("shadows.choose_all");
    markItem("shadows.choose_all");
  }
  ImGui::SameLine(right);
  removeButton(sliders);
}

void lightInIt(const ShadowSliders& sliders) {
  const ShadowKinds kinds = {Kind::Lighten, Kind::Deepen};
  ShadowOperation operation = shadowOperation(sliders.studio, sliders.light, kinds);
  float percent = (operation.kind == Kind::Deepen ? -100 : 100) * operation.amount;
  if (!labelledSlider(
          "Light", "shadows.lighten", &percent, -100, 100, "%+.0f %%",
          "Right: fills the shadow; at 100 % it is gone. Left: removes the light that is left in it."))
    return;
  operation.kind = percent < 0 ? Kind::Deepen : Kind::Lighten;
  operation.amount = std::abs(std::round(percent)) / 100;
  sliders.preview("light", kinds, operation);
}

void soften(const ShadowSliders& sliders) {
  ShadowOperation operation = shadowOperation(sliders.studio, sliders.light, {Kind::Soften});
  float pixels = operation.amount > 0 ? static_cast<float>(operation.radius) : 0;
  if (!labelledSlider("Soften", "shadows.soften", &pixels, 0, kMostSoft, "%.0f px",
                      "Softens the shadow's edge, as a larger source does. In image pixels.", kLogarithmic))
    return;
  operation.radius = std::max(1, static_cast<int>(std::round(pixels)));
  operation.amount = pixels >= 1 ? 1 : 0;
  sliders.preview("soften", {Kind::Soften}, operation);
}

void sharpen(const ShadowSliders& sliders) {
  ShadowOperation operation = shadowOperation(sliders.studio, sliders.light, {Kind::Sharpen});
  float percent = 100 * operation.amount;
  if (!labelledSlider("Sharpen", "shadows.sharpen", &percent, 0, 100, "%.0f %%",
                      "Hardens the shadow's edge, as a small source does."))
    return;
  operation.amount = std::round(percent) / 100;
  sliders.preview("sharpen", {Kind::Sharpen}, operation);
}

void recolor(const ShadowSliders& sliders) {
  const ShadowKinds kinds = {Kind::Recolor};
  ShadowOperation operation = shadowOperation(sliders.studio, sliders.light, kinds);
  const bool none = operation.amount == 0;
  if (none) operation.color = kFirstColor;
  ImGui::AlignTextToFramePadding();
  hint("Colour");
  ImGui::SameLine(px(kLabelWidth));
  Rgb codes = srgbFromLinear(operation.color);
  if (ImGui::ColorEdit3(
          "##colour", &codes.x,
          ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_PickerHueWheel)) {
    operation.color = linearFromSrgb(codes);
    if (none) operation.amount = 0.5F;
    sliders.preview("colour", kinds, operation);
  }
  markItem("shadows.colour");
  tooltip("Colour of the light that fills the shadow.");
  ImGui::SameLine(0, px(4));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  float percent = 100 * operation.amount;
  if (ImGui::SliderFloat("##recolor", &percent, 0, 100, "%.0f %%", ImGuiSliderFlags_AlwaysClamp)) {
    operation.amount = std::round(percent) / 100;
    sliders.preview("colour", kinds, operation);
  }
  markItem("shadows.recolor");
  tooltip("How much of that light fills the shadow.");
}

}  // namespace

void drawShadowSliders(EditingContext& studio, const std::string& light) {
  const ShadowSliders sliders{studio, light};
  target(sliders);
  lightInIt(sliders);
  soften(sliders);
  sharpen(sliders);
  recolor(sliders);
}

}  // namespace swaplight
