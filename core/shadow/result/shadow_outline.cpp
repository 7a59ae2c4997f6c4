#include "core/shadow/result/shadow_outline.h"

#include <cmath>

#include "core/shadow/result/label_mask.h"

namespace swaplight {
namespace {

/// Calls use(from, dx, dy, length) for every side of the closed line: its beginning and its direction of
/// length 1.
template <typename Use>
void eachSide(const Outline& outline, const Use& use) {
  for (size_t i = 0; i < outline.size(); ++i) {
    const auto& from = outline[i];
    const auto& to = outline[(i + 1) % outline.size()];
    const float length = std::hypot(to[0] - from[0], to[1] - from[1]);
    if (length > 0) use(from, (to[0] - from[0]) / length, (to[1] - from[1]) / length, length);
  }
}

}  // namespace

ShadowOutlines shadowOutlines(const std::vector<ShadowLabel>& labels, int width, float scale,
                              float tolerance) {
  return {outlinesOfMask(labelMask(labels, width, ShadowLabel::Umbra), scale, tolerance),
          outlinesOfMask(labelMask(labels, width, ShadowLabel::Penumbra), scale, tolerance)};
}

std::vector<OutlineTick> shadowTicks(const Outline& outline, float spacing, float length) {
  float whole = 0;
  eachSide(outline, [&](const auto&, float, float, float side) { whole += side; });
  std::vector<OutlineTick> ticks;
  if (!(spacing > 0) || whole < 2 * spacing) return ticks;
  float next = spacing / 2;  // the way along the side to the next tick
  eachSide(outline, [&](const std::array<float, 2>& from, float dx, float dy, float side) {
    for (; next < side; next += spacing) {
      const std::array<float, 2> foot{from[0] + next * dx, from[1] + next * dy};
      ticks.push_back({foot, {foot[0] + length * dy, foot[1] - length * dx}});
    }
    next -= side;
  });
  return ticks;
}

}  // namespace swaplight
