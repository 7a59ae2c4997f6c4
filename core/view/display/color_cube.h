#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/image/image.h"

namespace swaplight {

/// A table of colours over R, G, B, for functions too slow to be called for every pixel. Its axes run from 0
/// to 65536, piecewise linear in the logarithm: every octave up to 64 has the same number of vertices, black
/// is resolved, and the bends lie on vertices; what is brighter, where views are nearly white, has a vertex
/// every other octave.
class ColorCube {
 public:
  static constexpr int kVerticesPerOctave = 4;
  static constexpr int kLowestOctave = -8, kHighestOctave = 6, kLastOctave = 16;
  static constexpr int kOctavesPerStepBeyond = 2;
  static constexpr int kSide = (kHighestOctave - kLowestOctave) * kVerticesPerOctave +
                               (kLastOctave - kHighestOctave) / kOctavesPerStepBeyond + 1;
  static constexpr size_t kBlock =
      256;  ///< the most pixels that apply() takes, so that steps stay in the cache

  ColorCube() = default;
  /// Calls the function on an image that holds every vertex, in bands on several threads.
  explicit ColorCube(const std::function<void(ImageSpan)>& function);
  [[nodiscard]] bool empty() const { return m_vertices.empty(); }

  /// Interpolates in tetrahedra (Kasson, Plouffe and Nin 1993). What is negative or not a number counts as 0.
  /// Each argument is `count` values a channel, kBlock apart; in place is fine.
  void apply(const float* in, float* out, size_t count) const;

 private:
  std::vector<float> m_vertices;  ///< R G B 0, R fastest
};

}  // namespace swaplight
