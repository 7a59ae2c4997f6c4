#include "ui/color/swatch_row.h"

#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/relight/setting.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/light_words.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr float kHeight = 20, kWidth = 22, kGap = 4, kBetween = 12;
constexpr int kColumns = 8;  // of the menu

/// A colour that can be clicked: a copy, for the click may change the lists.
struct Swatch {
  LightColor color;
  bool kept;
  size_t place;
};

std::vector<Swatch> allSwatches(const Swatches& swatches) {
  std::vector<Swatch> all;
  for (const LightColor& color : swatches.kept()) all.push_back({color, true, all.size()});
  for (const LightColor& color : swatches.recent())
    all.push_back({color, false, all.size() - swatches.kept().size()});
  return all;
}

void giveColor(LightsContext& studio, size_t light, const LightColor& color) {
  editLights(studio, light, colorWords(color), [&](LightSetting& setting) { setting.color = color; });
}

void drawSwatch(LightsContext& studio, size_t light, const Swatch& swatch, const char* where) {
  const std::string mark = fmt::format("{}.{}.{}", where, swatch.kept ? "kept" : "recent", swatch.place);
  const std::string tip =
      fmt::format("{}{}. Click to give it to the light; right-click to {} it.", colorWords(swatch.color),
                  swatch.kept ? ", kept" : "", swatch.kept ? "remove" : "keep");
  if (colorChip(mark.c_str(), chipColor(swatch.color), ImVec2(px(kWidth), px(kHeight)), tip.c_str()))
    giveColor(studio, light, swatch.color);
  markItem(mark);
  if (!ImGui::BeginPopupContextItem(mark.c_str())) return;
  if (swatch.kept && ImGui::MenuItem("Remove this colour")) studio.swatches.drop(swatch.color);
  if (!swatch.kept && ImGui::MenuItem("Keep this colour")) studio.swatches.keep(swatch.color);
  markItem("swatch.menu");
  ImGui::EndPopup();
}

void keepButton(LightsContext& studio, const LightColor& color) {
  if (ImGui::Button(kIconAdd, ImVec2(px(kWidth), px(kHeight)))) studio.swatches.keep(color);
  markItem("swatch.keep");
  tooltip("Keep this light's colour here, for this and other sets.");
}

void moreMenu(LightsContext& studio, size_t light, const std::vector<Swatch>& all) {
  if (ImGui::Button(kIconMore, ImVec2(px(kWidth), px(kHeight)))) ImGui::OpenPopup("##swatches");
  markItem("swatch.more");
  tooltip("All colours that were kept, and those used last.");
  if (!ImGui::BeginPopup("##swatches")) return;
  for (const bool kept : {true, false}) {
    hint(kept ? "Kept" : "Used last");
    int column = 0;
    for (const Swatch& swatch : all) {
      if (swatch.kept != kept) continue;
      if (column++ % kColumns != 0) ImGui::SameLine(0, px(kGap));
      drawSwatch(studio, light, swatch, "swatches");
    }
    if (column == 0) hint("none yet");
  }
  ImGui::EndPopup();
}

/// Once the light's colour stays as it is, it has been used.
void noteUse(LightsContext& studio, size_t light, const LightColor& color) {
  if (studio.editor.inGesture()) return;
  std::string& seen = studio.mixer.colorSeen;
  const std::string name = studio.document().rig.lights[light].light + ' ';
  const std::string now = name + colorText(color);
  if (now == seen) return;
  if (seen.starts_with(name)) studio.swatches.use(color);
  seen = now;
}

}  // namespace

float swatchRowHeight() {
  return px(kHeight);
}

void drawSwatchRow(LightsContext& studio, size_t light, const LightColor& color) {
  noteUse(studio, light, color);
  const std::vector<Swatch> all = allSwatches(studio.swatches);
  const float step = px(kWidth + kGap);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
  const auto room = static_cast<size_t>(
      std::max(0.0F, (ImGui::GetContentRegionAvail().x - px(kBetween) - px(kWidth)) / step));
  keepButton(studio, color);
  size_t places = room > 2 ? room - 1 : 0;  // but for the last button
  for (const Swatch& swatch : all) {
    if (places-- == 0) break;
    ImGui::SameLine(0, px(!swatch.kept && swatch.place == 0 ? kBetween : kGap));
    drawSwatch(studio, light, swatch, "swatch");
  }
  ImGui::SameLine(ImGui::GetContentRegionMax().x - px(kWidth));
  moreMenu(studio, light, all);
  ImGui::PopStyleVar();
}

}  // namespace swaplight
