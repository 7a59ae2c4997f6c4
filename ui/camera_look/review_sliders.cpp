#include "ui/camera_look/review_sliders.h"

#include <imgui.h>

#include "ui/camera/camera_look_edit.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kReviewLabel = 92;
constexpr float kReviewDot = 18;

void reviewSlider(ViewerContext& studio, const char* name, const char* label, const char* tip) {
  float value = reviewValue(studio.document(), name);
  ImGui::PushID(name);
  ImGui::AlignTextToFramePadding();
  hint(label);
  ImGui::SameLine(px(kReviewLabel));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - px(kReviewDot));
  if (ImGui::SliderFloat("##value", &value, 0, 3, "%.2f", ImGuiSliderFlags_AlwaysClamp))
    setReview(studio.editor, name, value, true);
  markItem({"review.", name});
  tooltip(tip);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - px(kReviewDot - 4));
  if (changedDot("##changed", value != 1, "Changed: click for 1, which changes nothing."))
    setReview(studio.editor, name, 1, false);
  markItem({"review.", name, ".reset"});
  ImGui::PopID();
}

}  // namespace

void drawReviewSliders(ViewerContext& studio) {
  const bool open = ImGui::TreeNodeEx("Review", ImGuiTreeNodeFlags_SpanAvailWidth);
  markItem("camera_look.review");
  tooltip("Brightness, contrast, saturation and sharpness of the picture, after all filters.");
  if (!open) return;
  reviewSlider(studio, "brightness", "Brightness", "A factor: 1 changes nothing, 0 is black.");
  reviewSlider(studio, "contrast", "Contrast", "About the mean grey of the frame; 0 is that grey.");
  reviewSlider(studio, "saturation", "Saturation", "0 is black and white.");
  reviewSlider(studio, "sharpness", "Sharpness", "0 is soft, above 1 sharper.");
  ImGui::TreePop();
}

}  // namespace swaplight
