#include "ui/viewer/viewer_bar.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "core/ocio/color_config.h"
#include "core/set/set_color_space.h"
#include "ui/control/viewer_request.h"
#include "ui/kit/action_widgets.h"
#include "ui/viewer/bar_tools.h"
#include "ui/viewer/subject_menu.h"

namespace swaplight {
namespace {

std::string compareWords(CompareState::Mode mode) {
  constexpr std::array<const char*, 5> words = {"A", "Wipe", "Split", "A \u2212 B", "B"};
  return words[static_cast<size_t>(mode)];
}

void compareList(ViewerContext& studio) {
  for (const char* id :
       {"compare.off", "compare.wipe", "compare.split", "compare.difference", "compare.toggle"})
    actionMenuItem(studio.actions, id);
}

/// The display and the view that are in use, by name.
DisplayChoice shownThrough(const ViewerContext& studio) {
  const ColorConfig& config = *studio.colors.config();
  return namedDisplay(config, displayWithin(config, studio.document().display));
}

void chooseView(ViewerContext& studio, const DisplayChoice& choice) {
  try {
    studio.colors.config()->checkView(choice);
  } catch (const std::exception& error) {
    studio.messages.error(error.what());
    return;
  }
  studio.session.rememberView(choice);
  Document next = studio.document();
  next.display = choice;
  next.display.grade = studio.document().display.grade;
  studio.editor.edit("View: " + displayWords(choice), std::move(next));
}

/// The looks that a view is seen under: its own, none, one of the configuration's.
void drawLooks(ViewerContext& studio, const DisplayChoice& shown) {
  const ColorConfig& config = *studio.colors.config();
  std::vector<std::string> looks = config.looks();
  if (looks.empty()) return;
  if (shown.look && !shown.look->empty() && std::find(looks.begin(), looks.end(), *shown.look) == looks.end())
    looks.push_back(*shown.look);  // several at once, as a session may name them
  const auto line = [&](const std::string& words, const char* id, const std::optional<std::string>& look,
                        const std::string& tip) {
    if (ImGui::MenuItem(("   " + words + "##look").c_str(), nullptr, look == shown.look))
      chooseView(studio, {shown.display, shown.view, look});
    markItem({"look.", id});
    if (!tip.empty()) tooltip(tip.c_str());
  };
  ImGui::Separator();
  ImGui::TextDisabled("Look");
  const std::string own = config.viewLook(shown.display, shown.view);
  line("From the view: " + (own.empty() ? "none" : own), "own", std::nullopt,
       "A view may include a look. Looks grade the picture before the view, on the monitor and in exported "
       "PNG, TIFF and JPEG, never in EXR.");
  line("None", "none", "", "Apply the view without any look");
  for (const std::string& look : looks) line(look, look.c_str(), look, config.lookDescription(look));
}

}  // namespace

void drawDisplayMenu(ViewerContext& studio) {
  const ColorConfig& config = *studio.colors.config();
  const DisplayChoice shown = shownThrough(studio);
  ImGui::TextDisabled("Display");
  for (const std::string& display : config.displays()) {
    if (ImGui::MenuItem(("   " + display + "##display").c_str(), nullptr, display == shown.display)) {
      const std::vector<std::string> views = config.views(display);
      const bool has = std::find(views.begin(), views.end(), shown.view) != views.end();
      chooseView(studio, {display, has ? shown.view : config.defaultView(display), shown.look});
    }
    markItem({"display.", display});
  }
  ImGui::Separator();
  ImGui::TextDisabled("View");
  for (const std::string& view : config.views(shown.display)) {
    if (ImGui::MenuItem(("   " + view + "##view").c_str(), nullptr, view == shown.view))
      chooseView(studio, {shown.display, view, shown.look});
    markItem({"view.", shown.display, ".", view});
    const std::string description = config.viewDescription(shown.display, view);
    if (!description.empty()) tooltip(description.c_str());
  }
  drawLooks(studio, shown);
  ImGui::Separator();
  ImGui::TextDisabled("Colours: %s", config.title().c_str());
  if (const OpenSet* set = studio.set()) {
    const std::string space = setColorSpaceWords(set->original->colorSpace());
    const bool open = ImGui::BeginMenu(("Working space: " + space + "###working_space").c_str());
    markItem("working_space");
    if (open) {
      for (const char* id : {"working_space.own", "working_space.lin_rec709", "working_space.acescg"})
        actionMenuItem(studio.actions, id);
      ImGui::EndMenu();
    }
  }
  actionMenuItem(studio.actions, "view.color_config");
  actionMenuItem(studio.actions, "view.builtin_colors");
}

void drawViewerBar(ViewerContext& studio) {
  const float height = ImGui::GetFrameHeight() + px(8);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x + px(6), at.y + px(4)));
  // In a narrow viewer the lists' words are cut short, and what is used least goes into a list of its own, so
  // that the view stays in sight.
  const bool comparing = studio.view.compare.isOn();
  const float have = atScaleOne(ImGui::GetContentRegionAvail().x) - 6;
  const float wanted = comparing ? 790 : 660;
  const float cut = std::clamp((wanted - have) / (comparing ? 2 : 1), 0.0F, 54.0F);
  const float scarce = std::clamp((comparing ? 360 : 280) - have, 0.0F, 30.0F);  // their arrows stay
  listButton("##subject", subjectWords(studio, studio.view.subject), 144 - cut - scarce,
             "Picture shown in the viewer", [&] { drawSubjectMenu(studio, false); });
  listButton("##compare", compareWords(studio.view.compare.mode), 76 - scarce, "Compare with B",
             [&] { compareList(studio); });
  if (comparing)
    listButton("##side_b", sideBWords(studio), 124 - cut - scarce, "Picture B",
               [&] { drawSubjectMenu(studio, true); });
  drawBarTools(studio);
  const float room = ImGui::GetContentRegionAvail().x - px(6);
  listButton("##view", displayWords(shownThrough(studio)), std::clamp(atScaleOne(room), 60.0F, 190.0F),
             "Display and view, also used for PNG, TIFF and JPEG exports", [&] { drawDisplayMenu(studio); });
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + height));
}

}  // namespace swaplight
