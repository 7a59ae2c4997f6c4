#pragma once

#include <vector>

#include "core/set/solved_set.h"
#include "core/solve/highlights/light_saturation.h"

namespace swaplight {

/// What lies around a pixel, on a grid of cells (120 along the longer side), from a few pixels of each: what
/// surfaces without highlights are like there.
class HighlightSurroundings {
 public:
  /// Of a set with quality and some light.
  explicit HighlightSurroundings(const SolvedSet& set);

  struct Place {
    float error = 0;            ///< of a channel: geometric mean
    float saturation = 0;       ///< mean of what each pixel's most colourful light surely has; 0: not known
    float leastSaturation = 0;  ///< of nearly all surfaces there
    const float* level = nullptr;  ///< a value a light: the mean of its contribution
  };
  [[nodiscard]] Place at(int x, int y) const;

  /// The standard error that a channel has at least: a thousandth of the set's mean light.
  [[nodiscard]] float leastError() const { return m_leastError; }
  /// Whether a pixel's noise is so much more than around it that weaker lights are lost in a brighter one's.
  [[nodiscard]] static bool isSwamped(const LightSaturation& pixel, const Place& place);

  /// Calls use(x, y, pixel) for each of the pixels, 4 a cell, that were looked at.
  template <typename Use>
  void eachSample(const Use& use) const {
    const LightSaturation* pixel = m_samples.data();
    for (int y = m_step / 2; y < m_height; y += m_step)
      for (int x = m_step / 2; x < m_width; x += m_step) use(x, y, *pixel++);
  }

 private:
  void takeSamples(const SolvedSet& set);
  void measureErrors();
  void measureSurfaces();
  [[nodiscard]] size_t cellOf(int x, int y) const {
    return static_cast<size_t>(y / m_side) * static_cast<size_t>(m_columns) + static_cast<size_t>(x / m_side);
  }

  int m_width, m_height;
  int m_side;  // of a cell, pixels
  int m_step;  // from a sample to the next, pixels
  int m_columns, m_rows;
  int m_lights;
  float m_leastError = 0;
  std::vector<LightSaturation> m_samples;
  std::vector<float> m_error, m_saturation, m_leastSaturation;  // a value a cell
  std::vector<float> m_level;                                   // a value a cell and light
};

}  // namespace swaplight
