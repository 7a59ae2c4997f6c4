#include "core/edit/apply/highlight_row.h"

#include <algorithm>

namespace swaplight {
namespace {

struct Pair {
  float first, second;
};

Pair mixed(const float (&of)[2][2], float mask, const Pair& now) {
  const float first = std::max(of[0][0] * now.first + of[0][1] * now.second, 0.0F);
  const float second = std::max(of[1][0] * now.first + of[1][1] * now.second, 0.0F);
  return {now.first + mask * (first - now.first), now.second + mask * (second - now.second)};
}

float partOf(float highlight, float light) {
  return light > 0 ? std::min(highlight / light, 1.0F) : 0;
}

}  // namespace

void changeHighlightRow(float times, const float* mask, int count, const HighlightRow& row) {
  for (int i = 0; i < count; ++i) {
    const float step = mask[i] * (times - 1);
    const float all = 1 + step * row.part[i];
    row.light[i] *= all;
    row.part[i] = all > 0 ? row.part[i] * (1 + step) / all : 0;
  }
}

void mixTwoLightsRow(const float (&of)[2][2], const float* mask, int count, const HighlightRow& first,
                     const HighlightRow& second) {
  for (int p = 0; p < count; ++p) {
    if (!(mask[p] > 0)) continue;
    const Pair light{first.light[p], second.light[p]};
    const Pair next = mixed(of, mask[p], light);
    first.light[p] = next.first;
    second.light[p] = next.second;
    if (!first.part) continue;
    const Pair highlight = mixed(of, mask[p], {first.part[p] * light.first, second.part[p] * light.second});
    first.part[p] = partOf(highlight.first, next.first);
    second.part[p] = partOf(highlight.second, next.second);
  }
}

}  // namespace swaplight
