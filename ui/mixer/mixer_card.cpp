#include "ui/mixer/mixer_card.h"

namespace swaplight {

MixerCard::MixerCard(float height, bool chosen)
    : m_start(ImGui::GetCursorPos()), m_size(ImGui::GetContentRegionAvail().x, px(height)) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high(low.x + m_size.x, low.y + m_size.y);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, high, chosen ? kCardChosen : kCard, px(6));
  if (chosen) draw->AddRect(low, high, kAccent, px(6), 0, px(1));
}

ImVec2 MixerCard::at(float x, float y) const {
  return {m_start.x + px(kCardPadding) + x, m_start.y + px(kCardPadding) + y};
}

void MixerCard::toMiddleLine() const {
  ImGui::SetCursorPos(
      ImVec2(m_start.x + px(kCardPadding), m_start.y + (m_size.y - ImGui::GetFrameHeight()) / 2));
  ImGui::AlignTextToFramePadding();
}

void MixerCard::end() const {
  ImGui::SetCursorPos(ImVec2(m_start.x, m_start.y + m_size.y + px(6)));
}

}  // namespace swaplight
