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
      {{Mode::Add, "More light", "brush.add", "Adds light where you paint, even where it did not reach."},
       {Mode::Remove, "Less light", "brush.remove", "Removes light where you paint."},
       {Mode::Soften, "Soften", "brush.soften", "Softens the light's edges and shadows."},
       {Mode::SetTo, "Set to", "brush.set", "Sets the light to this level where you paint."}}};
  const float gap = px(4);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
  for (size_t i = 0; i < kChoices.size(); ++i) {
    if (i % 2 == 1) ImGui::SameLine(0, gap);
    const Choice& one = kChoices.at(i);
    if (choiceButton(one.words, brush.mode == one.mode, width, one.mark, one.tip)) brush.mode = one.mode;
  }
}

void energyMode(BrushState& brush, const std::string& light) {
  const float gap = px(4);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - gap) / 2);
  if (choiceButton(
          "Add light", brush.energy == EnergyMode::Add, width, "brush.meaning.add",
          "Adds or removes light; the other lights do not change. The picture gets brighter or darker."))
    brush.energy = EnergyMode::Add;
  ImGui::SameLine(0, gap);
  if (choiceButton("Keep total", brush.energy == EnergyMode::Redistribute, width, "brush.meaning.share",
                   ("What " + light +
                    " gains, the other lights lose, and vice versa. With every light at unit white the "
                    "picture does not change.")
                       .c_str()))
    brush.energy = EnergyMode::Redistribute;
}

void amount(BrushState& brush) {
  switch (brush.mode) {
    case Mode::Add:
      percentSlider("Light", "brush.light", &brush.light, 200,
                    "How much light is added: 100 % equals all lights together at unit white.");
      break;
    case Mode::Remove:
      break;
    case Mode::Soften: {
      float pixels = static_cast<float>(brush.softness);
      if (labelledSlider("Radius", "brush.softness", &pixels, 1, 256, "%.0f px",
                         "How far it spreads, in image pixels.", kLogarithmic))
        brush.softness = static_cast<int>(pixels);
      break;
    }
    case Mode::SetTo:
      percentSlider("Light", "brush.level", &brush.level, 200,
                    "The level to set: 100 % equals all lights together at unit white.");
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
  tooltip("To paint with another light, select it in the mixer.");
  modes(brush);
  amount(brush);
  energyMode(brush, light);
}

}  // namespace swaplight
