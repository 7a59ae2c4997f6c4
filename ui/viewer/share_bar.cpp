#include "ui/viewer/share_bar.h"

#include <fmt/core.h>
#include <imgui.h>

#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {

void drawShareBar(const std::string& name, float share, const Rgb& color, bool lit) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float row = ImGui::GetTextLineHeight() + px(4);
  const float left = px(76), right = px(48);
  const float inner = px(kSharesWidth) - 2 * px(10);
  const float room = inner - left - right;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  if (lit)
    draw->AddRectFilled(ImVec2(at.x - px(4), at.y - px(1)), ImVec2(at.x + inner + px(4), at.y + row - px(3)),
                        ImGui::GetColorU32(ImGuiCol_Header), px(3));
  draw->PushClipRect(at, ImVec2(at.x + left - px(4), at.y + row), true);
  draw->AddText(at, kText, name.c_str());
  draw->PopClipRect();
  const ImVec2 low(at.x + left, at.y + px(3));
  draw->AddRectFilled(low, ImVec2(low.x + room, low.y + row - px(8)), IM_COL32(70, 70, 70, 255), px(2));
  draw->AddRectFilled(low, ImVec2(low.x + room * share, low.y + row - px(8)), colorU32(color), px(2));
  const std::string number = fmt::format("{:.1f} %", 100 * share);
  draw->AddText(ImVec2(at.x + inner - ImGui::CalcTextSize(number.c_str()).x, at.y), kText, number.c_str());
  ImGui::Dummy(ImVec2(inner, row));
}

}  // namespace swaplight
