#include "core/edit/apply/gel_mixing.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/exponential.hpp>
#include <vector>

#include "core/base/error.h"
#include "core/solve/model/unknown_color.h"

namespace swaplight {
namespace {

/// The line of colours: m = k (1 - d) / (1 + d), d = (1 + p (most - 1)) direction.
struct GelLine {
  Rgb known{1}, direction{0};
  float most = 1;

  explicit GelLine(const OpenColor& open) {
    known = glm::sqrt(open.taken * open.exchanged);
    direction = (known - open.nearest) / (known + open.nearest);
    const Rgb end = (known - open.farthest) / (known + open.farthest);
    int widest = 0;
    for (int c = 1; c < 3; ++c)
      if (std::abs(direction[c]) > std::abs(direction[widest])) widest = c;
    if (direction[widest] != 0) most = std::max(end[widest] / direction[widest], 1.0F);
  }
  [[nodiscard]] float scale(float position) const { return 1 + position * (most - 1); }
  [[nodiscard]] Rgb at(float scale) const {
    const Rgb d = scale * direction;
    return known * (Rgb(1) - d) / (Rgb(1) + d);
  }
};

}  // namespace

GelMixing gelMixing(const SolvedSet& set, const UnknownGelOperation& operation) {
  const auto swapped = swappedColorOf(set.capture);
  if (!set.report || !set.report->openColor || !swapped)
    throw InputError("the set has no gel of which its photographs leave a number open: {} does nothing here",
                     UnknownGelOperation::info.name);
  const OpenColor& open = *set.report->openColor;
  const GelLine line(open);
  const float solved = line.scale(open.position);
  const bool exchanged = operation.lamps == UnknownGelOperation::Lamps::Exchanged;
  const float wanted = (exchanged ? -1.0F : 1.0F) * line.scale(operation.position);
  GelMixing mixing;
  mixing.lights[0] = swapped->lights[0];
  mixing.lights[1] = swapped->lights[1];
  mixing.color = line.at(wanted);
  const Rgb before = line.at(solved);
  const auto knownOf = [&](int j) {
    return *set.capture.shots[size_t(swapped->shots[j])].lightColors[size_t(swapped->lights[j])];
  };
  const Rgb lamps = glm::sqrt(knownOf(0) / knownOf(1));  // 1 where both lamps are of one white
  const float difference = solved / wanted;
  for (int c = 0; c < 3; ++c) {
    const float sum = (line.known[c] + before[c]) / (line.known[c] + mixing.color[c]) / 2;
    const float own = sum * (1 + difference), other = sum * (1 - difference);
    mixing.factor[c][0][0] = own;
    mixing.factor[c][0][1] = other / lamps[c];
    mixing.factor[c][1][0] = other * lamps[c];
    mixing.factor[c][1][1] = own;
  }
  return mixing;
}

std::optional<UnknownGelOperation> solvedGel(const SolvedSet& set) {
  if (!set.report || !set.report->openColor || !swappedColorOf(set.capture)) return std::nullopt;
  return UnknownGelOperation{set.report->openColor->position, UnknownGelOperation::Lamps::AsSolved};
}

void changeGelRow(const GelMixing& mixing, const float* mask, int count, const GelRows& rows) {
  std::vector<float> before(static_cast<size_t>(count));
  for (int c = 0; c < 3; ++c) {
    const float *a = rows.light[0][c].light, *b = rows.light[1][c].light;
    std::transform(a, a + count, b, before.begin(), std::plus());
    mixTwoLightsRow(mixing.factor[c], mask, count, rows.light[0][c], rows.light[1][c]);
    float* white = rows.white[c];
    for (int p = 0; p < count; ++p)
      if (const float sum = before[static_cast<size_t>(p)]; sum > 0) white[p] *= (a[p] + b[p]) / sum;
  }
  for (int p = 0; p < count; ++p) {
    const float grey = rows.white[0][p] + rows.white[1][p] + rows.white[2][p];
    rows.inverseGrey[p] = grey > 0 ? 1 / grey : 0;
  }
}

}  // namespace swaplight
