#include "core/edit/apply/reflectance_row.h"

#include <algorithm>

namespace swaplight {
namespace {

/// Of a pixel's mean: channels below it are noise rather than reflectance.
constexpr float kDim = 0.02F;

}  // namespace

void changeReflectanceRow(const float* const before[3], const float* const after[3], const float* inverseGrey,
                          float dark, int count, const SurfaceRow& light) {
  for (int p = 0; p < count; ++p) {
    if (!(inverseGrey[p] > 0)) continue;
    const float share = (light.channel[0][p] + light.channel[1][p] + light.channel[2][p]) * inverseGrey[p];
    const float dim = std::max(kDim / (3 * inverseGrey[p]), dark);
    for (int c = 0; c < 3; ++c) {
      float& t = light.channel[c][p];
      const float from = before[c][p], to = after[c][p];
      if (to < from)
        t *= to / from;
      else if (to > from)
        t += (to - from) * (t + dim * share) / (from + dim);
    }
  }
}

}  // namespace swaplight
