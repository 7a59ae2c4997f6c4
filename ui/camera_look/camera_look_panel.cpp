#include "ui/camera_look/camera_look_panel.h"

#include <imgui.h>

#include "ui/camera_look/filter_list.h"
#include "ui/camera_look/filter_parameters.h"
#include "ui/camera_look/filter_shelf.h"
#include "ui/camera_look/look_menu.h"
#include "ui/camera_look/review_sliders.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

/// The looks that come along and the person's own, and files.
void drawMenu(ViewerContext& studio) {
  if (!ImGui::BeginPopup("##camera look menu")) return;
  hint("Camera looks");
  if (drawLookLines({studio.editor, studio.shelf, studio.messages})) studio.cameraLook.chosen = -1;
  ImGui::Separator();
  for (const char* action : {"camera_look.load", "camera_look.save", "camera_look.remove"}) {
    const Action* one = studio.actions.find(action);
    if (one && ImGui::MenuItem(one->name.c_str(), nullptr, false, one->isEnabled())) one->run();
    markItem({"menu.", action});
  }
  ImGui::EndPopup();
}

void drawHeader(ViewerContext& studio) {
  const FilterPipeline& look = studio.document().cameraLook;
  ImGui::PushFont(fonts().strong);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(look.name.empty() ? "Camera look" : look.name.c_str());
  ImGui::PopFont();
  tooltip("What the lit picture is seen through: filters, from the top down. Hold V for the plain picture.");
  const float side = px(26);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - side);
  if (toggleButton(kIconMore, false, kAccent, side, "Choose, load, save or remove a camera look.")) {
    studio.shelf.readAgain();  // files may have been put there meanwhile
    ImGui::OpenPopup("##camera look menu");
  }
  markItem("camera_look.menu");
  drawMenu(studio);
}

}  // namespace

void drawCameraLookPanel(ViewerContext& studio, FileChooser& chooser) {
  CameraLookState& state = studio.cameraLook;
  const auto count = static_cast<int>(studio.document().cameraLook.stages.size());
  if (state.chosen >= count) state.chosen = count - 1;
  drawHeader(studio);
  drawFilterList(studio);
  std::optional<size_t>& alone = studio.viewer.filterAlone;  // follows the filter in focus
  if (alone) alone = state.chosen < 0 ? std::nullopt : std::optional(static_cast<size_t>(state.chosen));
  if (state.chosen >= 0 && state.chosen < static_cast<int>(studio.document().cameraLook.stages.size()))
    drawFilterParameters(studio, static_cast<size_t>(state.chosen), chooser);
  drawReviewSliders(studio);
  ImGui::Separator();
  drawFilterShelf(studio);
  markState("camera_look", std::to_string(studio.document().cameraLook.stages.size()));
}

}  // namespace swaplight
