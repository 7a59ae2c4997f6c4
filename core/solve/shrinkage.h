#pragma once

#include "core/solve/matte_fit.h"
#include "core/solve/shrinkage_kernel.h"

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
  Shrinkage(const EstimatorContext& context, const ShotSignal& signal);

  [[nodiscard]] const MatteFit& matte() const { return m_matte; }
  [[nodiscard]] const ShrinkagePrior& prior() const { return m_prior; }
  /// The chi-square beyond which a pixel is looked at closer.
  [[nodiscard]] float gate() const { return m_gate; }

  /// Contributions, residual, sigma of a run whose matte fit is given. `misfit` decides which pixels are
  /// looked at closer (it may be an earlier fit's); `odds` (may be null) multiplies the prior odds of not
  /// being matte. `notMatte` (may be null) receives the probability that the matte model was not enough.
  void finish(const PixelRun& in, const MatteRun& matte, const float* misfit, const float* odds,
              const SolvedRun& out, float* notMatte) const;

 private:
  void learn(const ShotSignal& signal);

  MatteFit m_matte;
  ShrinkagePlan m_plan;
  ShrinkagePrior m_prior;
  float m_gate = 0;
};

}  // namespace swaplight
