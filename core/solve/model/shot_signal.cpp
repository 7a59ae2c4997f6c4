#include "core/solve/model/shot_signal.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/parallel.h"
#include "core/set/solved_set.h"
#include "core/simd/padding.h"
#include "core/simd/simd.h"

namespace swaplight {
namespace {

constexpr size_t kChunk = 1 << 14;
/// Pictures lie around 1 (see signal_scale.h): what is so far above is damage, and its square would overflow.
constexpr float kHighest = 1e12F;

bool isBroken(float y, float lowest) {
  return !(y >= lowest) || y > kHighest;  // NaN, too
}

/// Whether every value lies in lowest <= y < clip (false for NaN).
SWAPLIGHT_SIMD(bool, allWithin, (const float* y, size_t count, float lowest, float clip),
               (y, count, lowest, clip)) {
  int outside = 0;
  for (size_t p = 0; p < count; ++p) outside |= !(y[p] >= lowest) | !(y[p] < clip);
  return outside == 0;
}

/// Of each shot the one of the same light with the next shorter exposure; -1 where there is none.
std::vector<int> shorterExposures(const LightingMatrix& lighting, const std::vector<float>& exposure) {
  const auto litAlike = [&](int a, int b) {
    constexpr float kRounding = 1e-5F;
    const float ratio = exposure[size_t(a)] / exposure[size_t(b)];
    for (int i = 0; i < lighting.lights; ++i)
      for (int c = 0; c < 3; ++c) {
        const float one = lighting.color(a, i)[c], other = ratio * lighting.color(b, i)[c];
        if (std::abs(one - other) > kRounding * std::max(one, other)) return false;
      }
    return true;
  };
  std::vector<int> shorter(size_t(lighting.shots), -1);
  for (int k = 0; k < lighting.shots; ++k)
    for (int j = 0; j < lighting.shots; ++j) {
      int& best = shorter[size_t(k)];
      const bool nearer = best < 0 || exposure[size_t(j)] > exposure[size_t(best)];
      if (exposure[size_t(j)] < exposure[size_t(k)] && nearer && litAlike(j, k)) best = j;
    }
  return shorter;
}

void flagOutside(const float* y, size_t count, float lowest, float clip, uint8_t* flags) {
  for (size_t p = 0; p < count; ++p) {
    if (isBroken(y[p], lowest))
      flags[p] |= kNotFinite;
    else if (y[p] >= clip)
      flags[p] |= kClipped;
  }
}

}  // namespace

ShotSignal::ShotSignal(const CapturePixels& pixels, const LightingMatrix& lighting, const NoiseModel& noise,
                       const std::vector<float>& exposure)
    : m_pixels(&pixels),
      m_needed(lighting.lights + 2),
      m_lowest(-std::max(6 * std::sqrt(noise.constant), 2e-3F)),
      m_exposure(exposure),
      m_shorter(shorterExposures(lighting, exposure)),
      m_pixelCount(pixels.shots.front().pixelCount()) {
  const int chunks = int((m_pixelCount + kChunk - 1) / kChunk);
  std::vector<uint8_t> dirty(size_t(chunks), 0);
  const auto eachPlane = [&](int chunk, auto&& look) {
    const size_t first = size_t(chunk) * kChunk;
    const size_t count = std::min(kChunk, m_pixelCount - first);
    for (size_t k = 0; k < pixels.shots.size(); ++k)
      for (int c = 0; c < 3; ++c) look(pixels.shots[k].plane(c) + first, count, pixels.clipLevel[k], first);
  };
  std::atomic<bool> anyDirty = false;
  parallelRows(chunks, 4, [&](int begin, int end) {
    for (int chunk = begin; chunk < end; ++chunk)
      eachPlane(chunk, [&](const float* y, size_t count, float clip, size_t) {
        if (!dirty[size_t(chunk)] && !allWithin(y, count, m_lowest, std::min(clip, kHighest)))
          dirty[size_t(chunk)] = 1, anyDirty = true;
      });
  });
  if (!anyDirty) return;
  m_flags.resize(m_pixelCount, 0);
  parallelRows(chunks, 4, [&](int begin, int end) {
    for (int chunk = begin; chunk < end; ++chunk)
      if (dirty[size_t(chunk)])
        eachPlane(chunk, [&](const float* y, size_t count, float clip, size_t first) {
          flagOutside(y, count, m_lowest, clip, m_flags.data() + first);
        });
  });
}

bool ShotSignal::flagged(size_t first, int count) const {
  if (m_flags.empty()) return false;
  for (int p = 0; p < count; ++p)
    if (m_flags[first + size_t(p)]) return true;
  return false;
}

std::vector<Rgb> ShotSignal::meanSignal() const {
  std::vector<Rgb> mean;
  const size_t step = std::max<size_t>(1, m_pixelCount / 50000);
  for (size_t k = 0; k < m_pixels->shots.size(); ++k) {
    double sum[3] = {};
    size_t count = 0;
    for (size_t p = 0; p < m_pixelCount; p += step) {
      if (!m_flags.empty() && m_flags[p]) continue;
      for (int c = 0; c < 3; ++c) sum[c] += m_pixels->shots[k].plane(c)[p];
      ++count;
    }
    const double scale = count ? 1 / double(count) : 0;
    mean.emplace_back(float(sum[0] * scale), float(sum[1] * scale), float(sum[2] * scale));
  }
  return mean;
}

void ShotSignal::run(size_t first, int count, bool mask, std::vector<float>& scratch, PixelRun& run) const {
  const auto& shots = m_pixels->shots;
  const bool bad = flagged(first, count);
  run.count = count;
  if (!bad && !m_pixels->ambient) {
    for (size_t k = 0; k < shots.size(); ++k)
      for (int c = 0; c < 3; ++c) run.signal[k][c] = shots[k].plane(c) + first;
    return;
  }
  const size_t padded = roundedUpToLanes(size_t(count));
  scratch.assign(padded * shots.size() * 3, 0.0F);
  const auto planeOf = [&](size_t k, int c) { return scratch.data() + (k * 3 + size_t(c)) * padded; };
  for (size_t k = 0; k < shots.size(); ++k)
    for (int c = 0; c < 3; ++c) {
      float* next = planeOf(k, c);
      run.signal[k][c] = next;
      const float* y = shots[k].plane(c) + first;
      if (m_pixels->ambient) {
        const float* ambient = m_pixels->ambient->plane(c) + first;
        const float scale = m_exposure[k];
        for (int p = 0; p < count; ++p)
          next[p] = std::isfinite(ambient[p]) ? y[p] - scale * ambient[p] : y[p];
      } else {
        std::copy_n(y, count, next);
      }
    }
  if (!bad) return;
  for (int p = 0; p < count; ++p)
    if (m_flags[first + size_t(p)]) repair(first + size_t(p), mask, scratch.data() + p, padded);
}

bool ShotSignal::isUsable(size_t pixel, size_t shot, int channel) const {
  const float y = m_pixels->shots[shot].plane(channel)[pixel];
  return !isBroken(y, m_lowest) && y < m_pixels->clipLevel[shot];
}

/// Without the values that are clipped or broken there are enough, in every channel one.
bool ShotSignal::hasEnough(size_t pixel) const {
  int good = 0;
  int inChannel[3] = {};
  for (size_t k = 0; k < m_pixels->shots.size(); ++k)
    for (int c = 0; c < 3; ++c)
      if (isUsable(pixel, k, c)) ++good, ++inChannel[c];
  return good >= m_needed && inChannel[0] > 0 && inChannel[1] > 0 && inChannel[2] > 0;
}

ShotSignal::Reading ShotSignal::reading(size_t pixel, int shot, int channel) const {
  const size_t k = size_t(shot);
  const float y = m_pixels->shots[k].plane(channel)[pixel];
  if (isBroken(y, m_lowest)) return {0, true};
  const float ambient = m_pixels->ambient ? m_exposure[k] * m_pixels->ambient->plane(channel)[pixel] : 0;
  return {m_pixels->shown(k, y) - (std::isfinite(ambient) ? ambient : 0), y >= m_pixels->clipLevel[k]};
}

std::vector<uint8_t> ShotSignal::undetermined() const {
  std::vector<uint8_t> marks(m_flags.size());
  for (size_t p = 0; p < marks.size(); ++p) marks[p] = m_flags[p] & kClipped && !hasEnough(p);
  return marks;
}

size_t ShotSignal::lostPixels() const {
  size_t lost = 0;
  for (size_t p = 0; p < m_flags.size(); ++p) lost += m_flags[p] & kNotFinite && !hasEnough(p);
  return lost;
}

/// `values`: those of the pixel, [shot * 3 + channel] `stride` apart.
void ShotSignal::repair(size_t pixel, bool mask, float* values, size_t stride) const {
  const auto& shots = m_pixels->shots;
  const bool dropClipped = mask && hasEnough(pixel);
  for (size_t k = 0; k < shots.size(); ++k)
    for (int c = 0; c < 3; ++c) {
      const float y = shots[k].plane(c)[pixel];
      const auto at = [&](size_t shot) -> float& { return values[(shot * 3 + size_t(c)) * stride]; };
      // The next shorter exposure that is usable, else the shortest that says at least how bright it is.
      int shorter = -1;
      for (int s = m_shorter[k]; s >= 0; s = m_shorter[size_t(s)]) {
        if (!isBroken(shots[size_t(s)].plane(c)[pixel], m_lowest)) shorter = s;
        if (isUsable(pixel, size_t(s), c)) break;
      }
      const bool told = shorter >= 0;
      const bool broken = isBroken(y, m_lowest), clipped = !broken && y >= m_pixels->clipLevel[k];
      if (broken || (clipped && (dropClipped || (mask && told))))
        at(k) = mask ? NAN : 0.0F;
      else if (clipped && told)
        at(k) = m_exposure[k] / m_exposure[size_t(shorter)] * at(size_t(shorter));
      else if (clipped)
        at(k) -= y - m_pixels->shown(k, y);
    }
}

}  // namespace swaplight
