#include "ui/edits/paint_modes.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <string>

#include "ui/control/light_edit.h"
#include "ui/kit/panel_controls.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

using Mode = BrushState::Mode;

void modes(BrushState& brush) {
  struct Choice {
    Mode mode;
    const char* words;
    const char* mark;
    const char* tip;
  };
  constexpr std::array<Choice, 4> kChoices{
      {{Mode::Add, "More light", "brush.add",
        "The light comes to where you paint, even where it did not reach."},
       {Mode::Remove, "Less light", "brush.remove", "The light goes away from where you paint."},
       {Mode::Soften, "Soften", "brush.soften", "The edges of the light and of its shadows become softer."},
       {Mode::SetTo, "Set to", "brush.set",
        "The light becomes this strong where you paint, whatever it was."}}};
  const float gap = px(4);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
  for (size_t i = 0; i < kChoices.size(); ++i) {
    if (i % 2 == 1) ImGui::SameLine(0, gap);
    const Choice& one = kChoices.at(i);
    if (choiceButton(one.words, brush.mode == one.mode, width, one.mark, one.tip)) brush.mode = one.mode;
  }
}

void meaning(BrushState& brush, const std::string& light) {
  const float gap = px(4);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
  hint("The other lights");
  if (choiceButton(
          "stay", brush.meaning == Meaning::Add, width, "brush.meaning.add",
          "Light is added or taken away; the other lights stay as they are. The picture gets brighter or "
          "darker."))
    brush.meaning = Meaning::Add;
  ImGui::SameLine(0, gap);
  if (choiceButton(
          "give way", brush.meaning == Meaning::Share, width, "brush.meaning.share",
          ("What " + light +
           " gets, the other lights lose, and the other way round. Under white lights the picture stays.")
              .c_str()))
    brush.meaning = Meaning::Share;
}

void amount(BrushState& brush) {
  switch (brush.mode) {
    case Mode::Add:
      percentSlider("Light", "brush.light", &brush.light, 200,
                    "How much comes: 100 % is as much as all lights together give there.");
      break;
    case Mode::Remove:
      break;
    case Mode::Soften: {
      float pixels = static_cast<float>(brush.softness);
      if (labelledSlider("Over", "brush.softness", &pixels, 1, 256, "%.0f px",
                         "Over how many pixels of the picture.", kLogarithmic))
        brush.softness = static_cast<int>(pixels);
      break;
    }
    case Mode::SetTo:
      percentSlider("Light", "brush.level", &brush.level, 200,
                    "How strong it becomes: 100 % is as much as all lights together give there.");
      break;
  }
}

}  // namespace

void drawPaintModes(EditingContext& studio) {
  BrushState& brush = studio.editing.brush;
  const std::string light = studio.document().rig.lights[shownLight(studio)].title();
  ImGui::PushFont(fonts().strong);
  ImGui::TextUnformatted(("Paint with " + light).c_str());
  ImGui::PopFont();
  tooltip("Another light: choose it in the list at the right.");
  modes(brush);
  amount(brush);
  meaning(brush, light);
}

}  // namespace swaplight
