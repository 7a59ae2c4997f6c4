#include "core/edit/pool/lamp_gain.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/edit/pool/small_samples.h"
#include "core/simd/simd.h"

namespace swaplight {
namespace {

constexpr int kCell = 8;                      // pixels: a gain is smooth
const double kMostLogGain = 4 * std::log(2);  // 4 stops
constexpr double kInner =
    0.1;  // radii, from the edge's inner end to where the light's own texture is all there is
constexpr double kSteep = 3;           // a change of the widened cone by a third makes the guess complete
constexpr float kLeastBounce = 1e-3F;  // so that the cones' ratio is finite
constexpr double kFarAway = 1e3;       // radii

// What a pixel's light becomes, before the gain. `would`: what it would give there without a cone.
float withCone(float light, float before, float after, float guess, float bounce, float would) {
  const float shown = (after + bounce) * would;
  const float kept = std::min(light * (after + bounce) / (before + bounce), std::max(light, shown));
  return kept + guess * (shown - kept);
}

// The shadows of a lamp of another size. Where more of the light is seen it is added. Where less is, what is
// there gets less, in its own colour: what a light would give is not known so well as what it gives. But it
// loses no more than the light that is hidden now: in a shadow most of what is there has bounced, and stays.
// What edits before this one took from the light they took from what is hidden of it, too.
SWAPLIGHT_SIMD(void, changeShadows,
               (const float* solved, const float* seen, const float* then, const float* direct, int count,
                float* light),
               (solved, seen, then, direct, count, light)) {
  for (int i = 0; i < count; ++i) {
    // Both ways are computed, without a division by 0: vectors have no branches.
    const bool taken = solved[i] > light[i];
    const float part = light[i] / (taken ? solved[i] : 1.F);
    const float change = (then[i] - seen[i]) * (taken ? part : 1.F) * direct[i];
    const float dimmed = light[i] * (then[i] / (seen[i] > 0 ? seen[i] : 1.F));
    const float more = light[i] + change;
    light[i] = then[i] >= seen[i] ? more : std::max(dimmed, more);
  }
}

SWAPLIGHT_SIMD(void, mixIn,
               (const float* gain, const float* changed, const float* mask, int count, float* light),
               (gain, changed, mask, count, light)) {
  for (int i = 0; i < count; ++i)
    light[i] = std::max(light[i] + mask[i] * (gain[i] * changed[i] - light[i]), 0.F);
}

// A lamp's size alone leaves the cone where it is: its edge gets softer as shadows do.
bool sameCone(LampChange change) {
  change.size = 1;
  return change.isNeutral();
}

}  // namespace

LampGain::LampGain(const LightPool& pool, const LampChange& change, int width, int height)
    : m_pool(pool),
      m_lamp(pool.lamp, change),
      m_width(width),
      m_height(height),
      m_coneMoves(pool.cone && !sameCone(change)),
      m_gain((height + kCell - 1) / kCell + 1, (width + kCell - 1) / kCell + 1, CV_32F) {
  parallelRows(m_gain.rows, 16, [&](int begin, int end) {
    for (int row = begin; row < end; ++row)
      for (int column = 0; column < m_gain.cols; ++column) {
        const double x = static_cast<double>(column * kCell) / width - .5;
        const double y = (.5 * height - row * kCell) / width;
        const double gain = std::clamp(m_lamp.logGain(x, y), -kMostLogGain, kMostLogGain);
        m_gain.at<float>(row, column) = static_cast<float>(std::exp(gain));
      }
  });
}

LampGain::Cones LampGain::conesAt(int x, int y) const {
  const LightCone& cone = *m_pool.cone;
  const double px = (x + .5) / m_width - .5;
  const double py = (.5 * m_height - (y + .5)) / m_width;
  double fromX = 0;
  double fromY = 0;
  const double now = cone.radius(px, py);
  const double source = m_lamp.sourceOf(px, py, fromX, fromY) ? cone.radius(fromX, fromY) : kFarAway;
  const double band = cone.softness + cone.unsure();
  const auto widened = [&](double radius) { return std::clamp((1 - radius) / band + .5, 0., 1.); };
  const double own = std::clamp((1 - .5 * band - now) / kInner, 0., 1.);
  const double change = std::min(kSteep * std::abs(widened(source) - widened(now)), 1.);
  return {static_cast<float>(cone.atRadius(now)), static_cast<float>(cone.atRadius(source)),
          static_cast<float>(change * (1 - own))};
}

void LampGain::gainRow(int x, int y, int count, float* gain) const {
  constexpr float kStep = 1.F / kCell;
  const SmallRow row{(static_cast<float>(x) + .5F) * kStep, (static_cast<float>(y) + .5F) * kStep, kStep};
  sampleRow(m_gain, row, count, gain);  // its values are those at the cells' corners
}

void LampGain::ratioRow(int channel, int x, int y, int count, float* ratio) const {
  const cv::Mat& small = m_pool.ratio[static_cast<size_t>(channel)];
  sampleRow(small, smallRow(x, y, {m_width, m_height}, small.size()), count, ratio);
}

void LampGain::coneRow(int x, int y, int count, const LampRow& row,
                       const std::array<float*, 3>& changed) const {
  std::vector<Cones> cones(static_cast<size_t>(count));
  int first = count;
  int end = 0;
  for (int i = 0; i < count; ++i) {
    const Cones here = cones[static_cast<size_t>(i)] = conesAt(x + i, y);
    if (here.isSame()) continue;
    first = std::min(first, i);
    end = i + 1;
  }
  if (first >= end) return;
  std::vector<float> ratio(static_cast<size_t>(count));
  const float bounce = static_cast<float>(m_pool.bounce) + kLeastBounce;
  for (int c = 0; c < 3; ++c) {
    ratioRow(c, x + first, y, end - first, ratio.data() + first);
    float* light = changed[static_cast<size_t>(c)];
    for (int i = first; i < end; ++i) {
      const Cones here = cones[static_cast<size_t>(i)];
      if (here.isSame()) continue;
      const float others =
          m_pool.alone ? 1.F : std::max(row.white[c][i] - row.solved[static_cast<size_t>(c)][i], 0.F);
      const float would =
          std::min(ratio[static_cast<size_t>(i)] * others, m_pool.most[static_cast<size_t>(c)]);
      light[i] = withCone(light[i], here.before, here.after, here.guess, bounce, would);
    }
  }
}

void LampGain::changeRow(int x, int y, int count, const float* mask, const LampRow& row) const {
  std::vector<float> gain(static_cast<size_t>(count));
  gainRow(x, y, count, gain.data());
  std::array<std::vector<float>, 3> changed;
  for (size_t c = 0; c < 3; ++c) {
    changed[c].assign(row.light[c], row.light[c] + count);
    if (row.seen)
      changeShadows(row.solved[c], row.seen, row.seenThen, row.direct[c], count, changed[c].data());
  }
  if (m_coneMoves) coneRow(x, y, count, row, {changed[0].data(), changed[1].data(), changed[2].data()});
  for (size_t c = 0; c < 3; ++c) mixIn(gain.data(), changed[c].data(), mask, count, row.light[c]);
}

float LampGain::guessAt(int x, int y) const {
  if (!m_coneMoves) return 0;
  const Cones cones = conesAt(x, y);
  return cones.after > cones.before ? std::min(cones.guess, 1 - cones.before / cones.after) : 0;
}

}  // namespace swaplight
