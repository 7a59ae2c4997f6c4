#include "ui/edits/edit_place.h"

#include <fmt/core.h>
#include <imgui.h>

#include <array>
#include <cmath>

#include "core/edit/mask/selection.h"
#include "ui/edits/edit_list.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/panel_controls.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"
#include "ui/tools/handle_tool.h"

namespace swaplight {
namespace {

std::string placeWords(const Mask& mask) {
  if (mask.empty()) return "everywhere";
  if (mask.size() > 1) return fmt::format("{} shapes", mask.size());
  const MaskShape& shape = mask.front();
  std::string words = std::visit([](const auto& s) { return s.info.title; }, shape.shape);
  if (const auto* shadow = std::get_if<ShadowShape>(&shape.shape))
    words = (shadow->region ? "a shadow of " : "shadows of ") + shadow->light;
  return shape.invert ? "not " + words : words;
}

/// A rectangle of half the picture's size in its middle.
RectangleShape firstRectangle(const EditingContext& studio) {
  const auto width = static_cast<float>(studio.set()->original->width());
  const auto height = static_cast<float>(studio.set()->original->height());
  return {std::round(width / 4), std::round(height / 4), std::round(width / 2), std::round(height / 2), 0};
}

void setPlace(EditingContext& studio, size_t index, Mask mask) {
  Edit next = *studio.document().edits.edits[index];
  next.mask = std::move(mask);
  const std::string step = "Where an edit acts: " + placeWords(next.mask);
  editEdit(studio, index, step, std::move(next));
}

void placeCombo(EditingContext& studio, size_t index) {
  const std::shared_ptr<const Edit> edit = studio.document().edits.edits[index];
  ImGui::AlignTextToFramePadding();
  hint("Where");
  ImGui::SameLine(px(kLabelWidth));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - px(6));
  const bool open = ImGui::BeginCombo("##where", placeWords(edit->mask).c_str());
  markItem("place");
  if (!open) return tooltip("Where the edit acts.");
  if (ImGui::Selectable("everywhere", edit->mask.empty())) setPlace(studio, index, {});
  markItem("place.everywhere");
  if (ImGui::Selectable("rectangle")) setPlace(studio, index, {{firstRectangle(studio), false}});
  markItem("place.rectangle");
  for (const Light& light : studio.set()->original->capture.lights) {
    if (ImGui::Selectable(("shadows of " + light.name).c_str()))
      setPlace(studio, index, {{ShadowShape{light.name, false, 0, 0}, false}});
    markItem({"place.shadows.", light.name});
  }
  const Mask& selection = studio.document().selection;
  if (!selection.empty() && ImGui::Selectable("the selection"))
    setPlace(studio, index, maskWithin({}, selection));
  const ShadowState& shadow = studio.editing.shadow;
  if (shadow.chosen && ImGui::Selectable("the selected shadow"))
    setPlace(studio, index, {{ShadowShape{shadow.light, true, shadow.chosen->x, shadow.chosen->y}, false}});
  ImGui::EndCombo();
}

/// The numbers of a rectangle.
void rectangle(EditingContext& studio, size_t index) {
  const std::shared_ptr<const Edit> edit = studio.document().edits.edits[index];
  const auto* shape =
      edit->mask.size() == 1 ? std::get_if<RectangleShape>(&edit->mask.front().shape) : nullptr;
  if (!shape) return;
  RectangleShape next = *shape;
  struct Number {
    float* value;
    const char* format;
    float least;
    const char* mark;
  };
  const std::array<Number, 5> numbers{{{&next.x, "x %.0f", -1e5F, "place.x"},
                                       {&next.y, "y %.0f", -1e5F, "place.y"},
                                       {&next.width, "w %.0f", 1, "place.width"},
                                       {&next.height, "h %.0f", 1, "place.height"},
                                       {&next.feather, "feather %.0f", 0, "place.feather"}}};
  const float width = std::floor((ImGui::GetContentRegionAvail().x - px(10)) / 2);
  bool changed = false;
  for (size_t i = 0; i < numbers.size(); ++i) {
    const Number& number = numbers.at(i);
    if (i % 2 == 1) ImGui::SameLine(0, px(4));
    ImGui::SetNextItemWidth(width);
    ImGui::PushID(static_cast<int>(i));
    changed |= ImGui::DragFloat("##number", number.value, 1, number.least, 1e5F, number.format,
                                ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopID();
    markItem(number.mark);
    tooltip("Image pixels. Drag, or double-click to type.");
  }
  if (!changed) return;
  Edit moved = *edit;
  moved.mask.front().shape = next;
  previewEdit(studio, index, "Rectangle of an edit", std::move(moved));
}

}  // namespace

void drawEditPlace(EditingContext& studio, size_t index) {
  placeCombo(studio, index);
  rectangle(studio, index);
  if (handlesShown(studio)) hint("Drag the handles in the picture.");
  const std::shared_ptr<const Edit> edit = studio.document().edits.edits[index];
  if (edit->mask.size() != 1) return;
  bool outside = edit->mask.front().invert;
  if (ImGui::Checkbox("invert", &outside)) {
    Mask mask = edit->mask;
    mask.front().invert = outside;
    setPlace(studio, index, std::move(mask));
  }
  markItem("place.outside");
}

}  // namespace swaplight
