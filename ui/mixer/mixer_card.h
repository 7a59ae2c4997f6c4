#pragma once

#include <imgui.h>

#include "ui/kit/theme.h"

namespace swaplight {

// What the mixer's rows have in common. Lengths at scale 1.

inline constexpr float kStopsRange = 10;  ///< of an intensity slider
inline constexpr float kCardPadding = 9;
inline constexpr float kNumberWidth = 84;
inline constexpr float kDotWidth = 14;
inline constexpr float kSwitchSide = 26;
inline constexpr ImU32 kLitPower = IM_COL32(92, 110, 92, 255);

/// Of a light's row, at scale 1. Narrow rows have the name and what is under it in one line.
struct RowShape {
  float height, gap, padding, chip, under, level;  ///< `under` and `level` from the padding down
  bool narrow;
};
inline constexpr RowShape kWideRow{82, 6, kCardPadding, 32, 18, 40, false};
inline constexpr RowShape kNarrowRow{60, 4, 5, 26, 4, 29, true};

/// The ground of a row, to put its widgets on, as wide as there is room.
class MixerCard {
 public:
  explicit MixerCard(float height, bool chosen = false);
  MixerCard(const RowShape& shape, bool chosen);
  /// Puts the cursor below the card.
  void end() const;

  [[nodiscard]] ImVec2 size() const { return m_size; }
  /// The place of the cursor for a part of it at x, y (in pixels) within the padding.
  [[nodiscard]] ImVec2 at(float x, float y) const;
  /// Within the padding.
  [[nodiscard]] float innerWidth() const { return m_size.x - 2 * px(kCardPadding); }
  /// Puts the cursor where widgets of one line lie in the middle of the card, at its left end.
  void toMiddleLine() const;

 private:
  ImVec2 m_start;
  ImVec2 m_size;
  float m_padding;  ///< above what is on the card, at scale 1
};

}  // namespace swaplight
