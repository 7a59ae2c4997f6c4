#pragma once

namespace swaplight {

/// Rows of one channel of a light: what it gives, >= 0, and what part of that is highlight, 0..1.
struct HighlightRow {
  float* light;
  float* part;
};

/// The highlight becomes `times` as much, where the mask (0..1) is 1: light += mask (times - 1) part light.
/// `times` >= 0. Where it is 1 light and part stay as they are to the bit.
void changeHighlightRow(float times, const float* mask, int count, const HighlightRow& row);

}  // namespace swaplight
