#pragma once

#include <imgui.h>

#include <string>

#include "ui/control/viewer_context.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {

inline constexpr float kBarGap = 5;  ///< between what stands in the viewer's bar

/// A button that opens a list; draws the list by `lines`. `width` in units of px().
template <typename Lines>
void listButton(const char* id, const std::string& shown, float width, const char* tip, const Lines& lines) {
  ImGui::SetNextItemWidth(px(width));
  const bool open = ImGui::BeginCombo(id, shown.c_str(), ImGuiComboFlags_HeightLargest);
  if (open) {
    lines();
    ImGui::EndCombo();
  }
  markItem({"bar.", id + 2});
  if (!open) tooltip(tip);
  ImGui::SameLine(0, px(kBarGap));
}

/// How to look at the picture: channel, exposure, zebra, false colours, gamma. Those for which the bar has no
/// room beside the display's list stand in a list that a button opens.
void drawBarTools(ViewerContext& studio);

}  // namespace swaplight
