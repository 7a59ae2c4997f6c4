#include "ui/viewer/bar_tools.h"

#include <array>

#include "ui/kit/action_widgets.h"
#include "ui/kit/icons.h"

namespace swaplight {
namespace {

constexpr float kGap = kBarGap;

void channelList(ViewerContext& studio) {
  for (const char* id : {"channel.all", "channel.red", "channel.green", "channel.blue", "channel.luminance"})
    actionMenuItem(studio.actions, id);
}

void number(const char* id, float* value, float width, float speed, float low, float high, const char* format,
            float neutral, const char* tip) {
  const bool changed = *value != neutral;
  if (changed) ImGui::PushStyleColor(ImGuiCol_Text, kChanged);
  ImGui::SetNextItemWidth(px(width));
  ImGui::DragFloat(id, value, speed, low, high, format, ImGuiSliderFlags_AlwaysClamp);
  if (changed) ImGui::PopStyleColor();
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) *value = neutral;
  markItem({"bar.", id + 2});
  tooltip(tip);
  ImGui::SameLine(0, px(kGap));
}

void zebraButton(ViewerContext& studio) {
  actionTextButton(studio.actions, "view.zebra", "Zebra", px(58));
  if (ImGui::BeginPopupContextItem("##zebra levels")) {
    Zebra& zebra = studio.view.settings.zebra;
    ImGui::SetNextItemWidth(px(200));
    ImGui::SliderFloat("bright", &zebra.high, 0, 1, "%.2f");
    ImGui::SetNextItemWidth(px(200));
    ImGui::SliderFloat("dark", &zebra.low, 0, 1, "%.2f");
    ImGui::EndPopup();
  }
  ImGui::SameLine(0, px(kGap));
}

void channelButton(ViewerContext& studio) {
  constexpr std::array<const char*, 5> channels = {"RGB", "R", "G", "B", "L"};
  listButton("##channel", channels[static_cast<size_t>(studio.view.settings.channel)], 70, "Channel",
             [&] { channelList(studio); });
}

/// How to look at the picture, the most used first.
struct BarTool {
  float width;  ///< in units of px(), with the gap behind it
  void (*draw)(ViewerContext& studio);
};
constexpr std::array<BarTool, 5> kTools = {{
    {70 + kGap, channelButton},
    {82 + kGap,
     [](ViewerContext& studio) {
       number(
           "##exposure", &studio.view.settings.exposureStops, 82, 0.02F, -20, 20, "%+.2f st", 0,
           "Viewer exposure, never exported. Drag, or hold E and drag in the picture. Right-click resets.");
     }},
    {58 + kGap, zebraButton},
    {96 + kGap,
     [](ViewerContext& studio) {
       actionTextButton(studio.actions, "view.false_color", "False colour", px(96));
       ImGui::SameLine(0, px(kGap));
     }},
    {62 + kGap,
     [](ViewerContext& studio) {
       number("##gamma", &studio.view.settings.gamma, 62, 0.005F, 0.1F, 10, "\u03b3 %.2f", 1,
              "Viewer gamma, never exported. Right-click resets.");
     }},
}};
constexpr float kMoreWidth = 26;
constexpr float kLeastView = 96;  ///< "Display / View" can still be told

/// How many of them stand in the bar beside the view.
size_t toolsThatFit(float room) {
  float all = 0;
  for (const BarTool& tool : kTools) all += tool.width;
  if (all + kLeastView <= room) return kTools.size();
  float used = kMoreWidth + kGap + kLeastView;
  size_t count = 0;
  while (count < kTools.size() && used + kTools[count].width <= room) used += kTools[count++].width;
  return count;
}

}  // namespace

void drawBarTools(ViewerContext& studio) {
  const size_t count = toolsThatFit(atScaleOne(ImGui::GetContentRegionAvail().x) - 6);
  for (size_t i = 0; i < count; ++i) kTools[i].draw(studio);
  if (count == kTools.size()) return;
  if (toggleButton(kIconMore, false, kAccent, px(kMoreWidth), "More ways to look at the picture"))
    ImGui::OpenPopup("##more tools");
  markItem("bar.more");
  ImGui::SameLine(0, px(kGap));
  if (!ImGui::BeginPopup("##more tools")) return;
  for (size_t i = count; i < kTools.size(); ++i) {
    kTools[i].draw(studio);
    ImGui::NewLine();
  }
  ImGui::EndPopup();
}

}  // namespace swaplight
