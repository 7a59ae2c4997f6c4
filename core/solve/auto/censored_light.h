#pragma once

#include <span>
#include <vector>

#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// The contributions T >= 0 of a channel of a pixel by censored least squares (after Tobin 1958): what is
/// clipped is a lower bound.
///
///   sum over usable shots of (a_k T - y_k)^2 / var_k + sum over clipped ones of max(0, y_k - a_k T)^2 /
///   var_k
///
/// var holds the noise, and the part `modelError` of a value by which it may miss the model.
class CensoredLight {
 public:
  /// `readings`: of every shot. All outlive it.
  CensoredLight(const EstimatorContext& context, int channel, std::span<const ShotSignal::Reading> readings,
                double modelError);

  /// What a shot gets of some light.
  [[nodiscard]] double predicted(size_t shot, std::span<const double> light) const;
  /// The light in such proportions that the readings want: of what is clipped the least that clips.
  [[nodiscard]] double scale(std::span<const double> proportions) const;

  /// |T - b (b T) / (b b)|^2 times `weight`: proportions b from which the light does not like to stray.
  struct Prior {
    std::vector<double> proportions;
    double weight = 0;
  };
  /// From `light` on, by coordinate descent, until nothing changes by more than `settled`.
  void descend(std::vector<double>& light, const Prior& prior, double settled) const;

 private:
  [[nodiscard]] double color(size_t shot, int light) const {
    return double(m_lighting.color(int(shot), light)[m_channel]);
  }
  /// Each light by itself, the others held. Returns the largest change.
  [[nodiscard]] double sweep(std::vector<double>& light, const Prior& prior) const;

  const LightingMatrix& m_lighting;
  int m_channel;
  std::span<const ShotSignal::Reading> m_readings;
  std::vector<double> m_weights;
};

}  // namespace swaplight
