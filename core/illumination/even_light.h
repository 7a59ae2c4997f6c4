#pragma once

#include "core/edit/pool/small_samples.h"
#include "core/illumination/local_fit.h"
#include "core/illumination/small_lights.h"

namespace swaplight {

/// What each light gives to a surface of the set's mean grey, where its pixels are: its share of all light,
/// times the level of all light, which is fitted (illumination.h).
class EvenLight {
 public:
  explicit EvenLight(const SmallLights& small);

  /// Pixels in a row. `light`: of each light, channels' mean; `at`: where the row lies in the small pictures;
  /// `out`: of each light.
  void row(const float* const* light, const SmallRow& at, int count, float* const* out) const;
  [[nodiscard]] size_t lights() const { return m_lights; }

 private:
  size_t m_lights;
  float m_floor;          // added to all light: noise from here on
  float m_least, m_most;  // of the logarithm of all light: nothing beyond is believed
  LocalFit m_level;       // of the logarithm of all light, along the roots of the lights' shares
};

/// A light without relief: the logarithm of its level, smoothed where it varies little (the guided filter,
/// guided by the picture itself).
class ReliefFilter {
 public:
  /// `light`: small. `sigma`: in its pixels.
  ReliefFilter(const cv::Mat& light, double sigma);

  /// Changes a row of the light.
  void row(const SmallRow& at, int count, float* light) const;

 private:
  float m_floor;
  cv::Mat m_slope, m_offset;
};

}  // namespace swaplight
