#include "core/edit/apply/highlight_row.h"

namespace swaplight {

void changeHighlightRow(float times, const float* mask, int count, const HighlightRow& row) {
  for (int i = 0; i < count; ++i) {
    const float step = mask[i] * (times - 1);
    const float all = 1 + step * row.part[i];
    row.light[i] *= all;
    row.part[i] = all > 0 ? row.part[i] * (1 + step) / all : 0;
  }
}

}  // namespace swaplight
