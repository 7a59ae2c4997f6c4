#pragma once

#include <span>

#include "core/simd/plane_arena.h"
#include "core/solve/model/pixel_run.h"

namespace swaplight {

/// Pixels from anywhere, gathered into planes that a kernel can run over.
class PackedRun {
 public:
  PackedRun(int shots, size_t capacity) : m_shots(shots), m_arena(capacity, size_t(3 * shots)) {
    // What lies beyond the last pixel takes part in its lanes' steps: it must not differ from run to run.
    for (int k = 0; k < shots; ++k)
      for (int c = 0; c < 3; ++c) m_run.signal[k][c] = m_plane[k][c] = m_arena.take(0);
  }
  void add(const PixelRun& from, int index) {
    for (int k = 0; k < m_shots; ++k)
      for (int c = 0; c < 3; ++c) m_plane[k][c][m_run.count] = from.signal[k][c][index];
    ++m_run.count;
  }
  void add(const PixelRun& from, std::span<const int> indices) {
    for (int k = 0; k < m_shots; ++k)
      for (int c = 0; c < 3; ++c) {
        float* to = m_plane[k][c] + m_run.count;
        for (const int index : indices) *to++ = from.signal[k][c][index];
      }
    m_run.count += int(indices.size());
  }
  /// A pixel's values of all shots and channels, [3 shot + channel].
  template <typename Values>
  void add(const Values& values) {
    for (int k = 0; k < m_shots; ++k)
      for (int c = 0; c < 3; ++c) m_plane[k][c][m_run.count] = float(values[3 * k + c]);
    ++m_run.count;
  }
  [[nodiscard]] const PixelRun& run() const { return m_run; }

 private:
  int m_shots;
  PlaneArena m_arena;
  PixelRun m_run;
  float* m_plane[kMaxShots][3];
};

}  // namespace swaplight
