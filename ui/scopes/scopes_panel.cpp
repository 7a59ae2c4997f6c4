#include "ui/scopes/scopes_panel.h"

#include <algorithm>

#include "ui/kit/action_widgets.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

using Of = ScopeOptions::Of;
using Axis = ScopeOptions::Axis;

/// What has no room beside the others stands below them.
void breakLine(float width) {
  if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
}

void toggle(const char* name, bool* on) {
  breakLine(ImGui::CalcTextSize(name).x + 2 * ImGui::GetStyle().FramePadding.x);
  pushChosen(*on);
  const bool clicked = ImGui::SmallButton(name);
  popChosen();
  if (clicked) *on = !*on;
  markItem({"scopes.", name});
  ImGui::SameLine(0, px(4));
}

template <typename Choice>
void choice(const char* id, Choice* chosen, const std::vector<std::pair<Choice, std::string>>& choices,
            float width) {
  std::string shown;
  for (const auto& [value, name] : choices)
    if (value == *chosen) shown = name;
  breakLine(px(width));
  ImGui::SetNextItemWidth(px(width));
  const bool open = ImGui::BeginCombo(id, shown.c_str());
  if (open) {
    for (const auto& [value, name] : choices) {
      if (ImGui::Selectable(name.c_str(), value == *chosen)) *chosen = value;
      markItem({"scopes.", name});
    }
    ImGui::EndCombo();
  }
  markItem({"scopes.", id + 2});
  ImGui::SameLine(0, px(4));
}

/// The unit of the scales of display codes; nits only of displays whose luminance is known.
ScopeUnit unitOf(const ScopeOptions& options, const DisplayLuminance& shown) {
  return options.unit == ScopeUnit::Nits && !shown.known() ? ScopeUnit::Percent : options.unit;
}

void unitChoice(ScopeOptions& options, const DisplayLuminance& shown) {
  std::vector<std::pair<ScopeUnit, std::string>> units = {
      {ScopeUnit::Codes8, "8 bit"}, {ScopeUnit::Codes10, "10 bit"}, {ScopeUnit::Percent, "Per cent"}};
  if (shown.known()) units.emplace_back(ScopeUnit::Nits, "Nits");
  ScopeUnit unit = unitOf(options, shown);
  const ScopeUnit before = unit;
  choice<ScopeUnit>("##unit", &unit, units, 84);
  if (unit != before) options.unit = unit;
}

void header(const ChosenLights& chosen, ScopeOptions& options, const DisplayLuminance& shown,
            const ActionTable& actions) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(7), px(1)));
  ImGui::PushFont(fonts().small);
  toggle("Waveform", &options.waveform);
  toggle("Parade", &options.parade);
  toggle("Vectorscope", &options.vectorscope);
  toggle("Histogram", &options.histogram);
  toggle("Chromaticity", &options.chromaticity);
  const std::vector<LightSetting>& lights = chosen.document().rig.lights;
  const auto light = static_cast<size_t>(std::max(0, chosen.view.selectedLight));
  choice<Of>("##of", &options.of,
             {{Of::Frame, "Whole picture"},
              {Of::Region, "Region"},
              {Of::Light, "of " + (light < lights.size() ? lights[light].title() : "a light")}},
             118);
  if (options.of == Of::Region) {
    breakLine(px(48));
    actionTextButton(actions, "scopes.region", "Draw", px(48));
    ImGui::SameLine(0, px(4));
  }
  if (options.waveform || options.parade || options.histogram) unitChoice(options, shown);
  if (options.histogram) {
    choice<Axis>(
        "##axis", &options.histogramAxis,
        {{Axis::Codes, "Display values"}, {Axis::Stops, "Stops from grey"}, {Axis::Linear, "Linear light"}},
        160);
    toggle("log", &options.logCounts);
  }
  ImGui::PopFont();
  ImGui::PopStyleVar();
  ImGui::NewLine();
}

}  // namespace

void ScopesPanel::upload() {
  if (m_uploaded == m_controller.revision()) return;
  m_uploaded = m_controller.revision();
  const ScopePictures& pictures = *m_controller.pictures();
  const auto update = [](SurfaceTexture& texture, const ScopePicture& picture) {
    texture.update(picture.width, picture.height, picture.rgba.data());
  };
  update(m_textures.waveform, pictures.waveform);
  update(m_textures.parade, pictures.parade);
  update(m_textures.vectorscope, pictures.vectorscope);
  update(m_textures.chromaticity, pictures.chromaticity);
}

void ScopesPanel::draw(const ChosenLights& lights, ScopeOptions& options, const ActionTable& actions) {
  m_controller.update();
  const DisplayLuminance& shown = m_controller.displayLuminance();
  header(lights, options, shown, actions);
  if (!m_controller.pictures()) return;
  upload();
  const std::vector<ScopeTick> scale = scopeTicks(unitOf(options, shown), shown);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float gap = px(10);
  // Vectorscope and chromaticities are square; the others share what is left.
  const int squares = (options.vectorscope ? 1 : 0) + (options.chromaticity ? 1 : 0);
  const int wide = (options.waveform ? 1 : 0) + (options.parade ? 1 : 0) + (options.histogram ? 1 : 0);
  if (squares + wide == 0) return;
  const float even =
      (room.x - gap * static_cast<float>(squares + wide - 1)) / static_cast<float>(squares + wide);
  const float square = wide == 0 ? even : std::min(room.y + px(10), even);
  const float rest =
      wide == 0
          ? 0
          : (room.x - static_cast<float>(squares) * square - gap * static_cast<float>(squares + wide - 1)) /
                static_cast<float>(wide);
  float x = at.x;
  const auto place = [&](float width, const char* mark, const auto& draw) {
    const ImVec2 low(std::floor(x), at.y), high(std::floor(x + width), at.y + room.y);
    draw(low, high);
    markRect({"scope.", mark}, low.x, low.y, high.x, high.y);
    x += width + gap;
  };
  if (options.waveform)
    place(rest, "waveform",
          [&](ImVec2 low, ImVec2 high) { drawWaveform(m_textures.waveform.id(), 1, scale, low, high); });
  if (options.parade)
    place(rest, "parade",
          [&](ImVec2 low, ImVec2 high) { drawWaveform(m_textures.parade.id(), 3, scale, low, high); });
  if (options.vectorscope)
    place(square, "vectorscope",
          [&](ImVec2 low, ImVec2 high) { drawVectorscope(m_textures.vectorscope.id(), low, high); });
  if (options.histogram)
    place(rest, "histogram", [&](ImVec2 low, ImVec2 high) {
      drawHistogram(*m_controller.pictures(), options, scale, low, high);
    });
  if (options.chromaticity)
    place(square, "chromaticity", [&](ImVec2 low, ImVec2 high) {
      drawChromaticity(lights.document().rig.lights, m_textures.chromaticity.id(), low, high);
    });
}

}  // namespace swaplight
