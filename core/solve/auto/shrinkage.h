#pragma once

#include "core/solve/auto/auto_tuning.h"
#include "core/solve/auto/shrinkage_kernel.h"
#include "core/solve/estimators/matte_fit.h"

namespace swaplight {

class ShotSignal;

/// Model `auto`: only what the pixel needs.
///   T = beta x rho + delta,   delta ~ N(0, tau^2 P),   P = per light w 11' + (1 - w) I over the channels
/// (gloss is mostly white: w = 0.8). tau = 0 is the matte fit, large tau the full demultiplex where that is
/// determined and the matte model's guess, led by the other channels, where it is not. For each tau of a few,
/// beta and rho are refitted by one step of generalised least squares; their answers are mixed by evidence
///   -1/2 r'S^-1 r - 1/2 log|S| - 1/2 log|J'S^-1 J|,   S = tau^2 A P A' + V
/// times a prior that the set itself provides (expectation-maximisation over a sample). The noise is taken as
/// V = v(pixel) D with D one a capture, so that one singular value decomposition of D^-1/2 A P^1/2 makes S
/// diagonal for every pixel and tau. Pixels that the matte model explains go no further.
class Shrinkage {
 public:
  Shrinkage(const EstimatorContext& context, const ShotSignal& signal, const ShrinkageTuning& tuning);

  [[nodiscard]] const MatteFit& matte() const { return m_matte; }

  /// Learns the prior from a sample of the set. `noise` (a plane; may be null) multiplies the variance.
  void learn(const ShotSignal& signal, const float* noise);

  /// What is known of a run's pixels from elsewhere.
  struct Evidence {
    const float* misfit;           ///< chi-square that decides which pixels are looked at closer
    const float* odds = nullptr;   ///< factor of the prior odds of not being matte
    const float* noise = nullptr;  ///< factor of the noise model's variance
  };
  /// Contributions, residual, sigma of a run whose matte fit is given. `notMatte` (may be null) receives the
  /// probability that the matte model was not enough. The evidence may lie in the planes of the answer.
  void finish(const PixelRun& in, const MatteRun& matte, const Evidence& evidence, const SolvedRun& out,
              float* notMatte) const;

 private:
  ShrinkageTuning m_tuning;
  MatteFit m_matte;
  ShrinkagePlan m_plan;
  float m_gate = 0;
};

}  // namespace swaplight
