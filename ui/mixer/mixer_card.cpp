#include "ui/mixer/mixer_card.h"

namespace swaplight {

MixerCard::MixerCard(float height, bool chosen)
    : MixerCard({height, kWideRow.gap, kWideRow.padding, 0, 0, 0, false}, chosen) {}

MixerCard::MixerCard(const RowShape& shape, bool chosen)
    : m_start(ImGui::GetCursorPos()),
      m_size(ImGui::GetContentRegionAvail().x, px(shape.height)),
      m_padding(shape.padding) {
  // Above all but the first: below the last one it would be scrolled to.
  if (m_start.y > 0) m_start.y += px(shape.gap);
  ImGui::SetCursorPos(m_start);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high(low.x + m_size.x, low.y + m_size.y);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, high, chosen ? kCardChosen : kCard, px(6));
  if (chosen) draw->AddRect(low, high, kAccent, px(6), 0, px(1));
}

ImVec2 MixerCard::at(float x, float y) const {
  return {m_start.x + px(kCardPadding) + x, m_start.y + px(m_padding) + y};
}

void MixerCard::toMiddleLine() const {
  ImGui::SetCursorPos(
      ImVec2(m_start.x + px(kCardPadding), m_start.y + (m_size.y - ImGui::GetFrameHeight()) / 2));
  ImGui::AlignTextToFramePadding();
}

void MixerCard::end() const {
  ImGui::SetCursorPos(ImVec2(m_start.x, m_start.y + m_size.y));
}

}  // namespace swaplight
