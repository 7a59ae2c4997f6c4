#pragma once

#include <span>
#include <vector>

#include "core/simd/lanes.h"
#include "core/solve/model/estimator.h"

namespace swaplight {

/// Pixels from anywhere, gathered into planes that a kernel can run over.
class PackedRun {
 public:
  PackedRun(int shots, size_t capacity)
      : m_shots(shots), m_padded((capacity + kLanes - 1) / kLanes * kLanes) {
    m_data.resize(m_padded * size_t(3 * shots), 0.0F);
    for (int k = 0; k < shots; ++k)
      for (int c = 0; c < 3; ++c) m_run.signal[k][c] = plane(k, c);
  }
  void add(const PixelRun& from, int index) {
    for (int k = 0; k < m_shots; ++k)
      for (int c = 0; c < 3; ++c) plane(k, c)[m_run.count] = from.signal[k][c][index];
    ++m_run.count;
  }
  void add(const PixelRun& from, std::span<const int> indices) {
    for (int k = 0; k < m_shots; ++k)
      for (int c = 0; c < 3; ++c) {
        float* to = plane(k, c) + m_run.count;
        for (const int index : indices) *to++ = from.signal[k][c][index];
      }
    m_run.count += int(indices.size());
  }
  [[nodiscard]] const PixelRun& run() const { return m_run; }

 private:
  float* plane(int shot, int channel) { return m_data.data() + size_t(shot * 3 + channel) * m_padded; }
  int m_shots;
  size_t m_padded;
  std::vector<float> m_data;
  PixelRun m_run;
};

}  // namespace swaplight
