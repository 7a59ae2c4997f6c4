#pragma once

namespace swaplight {

/// Rows of one channel of a light: what it gives, >= 0, and what part of that is highlight, 0..1; nullptr:
/// not known.
struct HighlightRow {
  float* light;
  float* part;
};

/// The highlight becomes `times` as much, where the mask (0..1) is 1: light += mask (times - 1) part light.
/// `times` >= 0; the part is known. Where it is 1 light and part stay as they are to the bit.
void changeHighlightRow(float times, const float* mask, int count, const HighlightRow& row);

/// Where the mask (0..1) is 1 each of two lights becomes a sum of both, at least 0:
///   light i = of[i][0] first + of[i][1] second
/// Their highlights go with the light. Where it is 0 both stay as they are to the bit.
void mixTwoLightsRow(const float (&of)[2][2], const float* mask, int count, const HighlightRow& first,
                     const HighlightRow& second);

}  // namespace swaplight
