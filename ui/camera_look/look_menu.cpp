#include "ui/camera_look/look_menu.h"

#include <imgui.h>

#include "ui/camera/camera_look_edit.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kStarSide = 22;

void drawStar(const LookChoice& studio, const FilterPipeline& look) {
  const bool on = studio.shelf.isFavourite(look.name);
  ImGui::PushStyleColor(ImGuiCol_Text, on ? kSolo : kFaint);
  ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
  const bool clicked = ImGui::Button(on ? kIconStar : kIconStarBorder, ImVec2(px(kStarSide), px(kStarSide)));
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
  markItem({"camera_look.star.", look.name});
  tooltip(on ? "A favourite, in the mixer. Click to take it away from there."
             : "Make it a favourite: one click away in the mixer, for this and other sets.");
  if (!clicked) return;
  try {
    studio.shelf.star(look.name, !on);
  } catch (const std::exception& error) {
    studio.messages.error(error.what());
  }
}

}  // namespace

bool drawLookLines(const LookChoice& studio) {
  const std::string current = studio.editor.document().cameraLook.name;  // a copy: a click changes it
  bool chosen = false;
  for (const FilterPipeline& look : studio.shelf.looks()) {
    ImGui::PushID(look.name.c_str());
    drawStar(studio, look);
    ImGui::SameLine();
    if (ImGui::MenuItem(look.name.c_str(), nullptr, current == look.name)) {
      useCameraLook(studio.editor, studio.shelf.lookOf(look));
      chosen = true;
    }
    markItem({"camera_look.look.", look.name});
    ImGui::PopID();
  }
  return chosen;
}

}  // namespace swaplight
