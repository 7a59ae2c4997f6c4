#pragma once

#include "core/solve/estimators/matte_kernel.h"
#include "core/solve/model/estimator.h"

namespace swaplight {

/// The matte model T[i][c] = beta[i] rho[c] by maximum likelihood over all shots.
///
/// rho is eliminated (variable projection): for u >= 0 of any scale, with w = 1 / variance,
///   p_c = sum_k w y l_k,  Q_c = sum_k w l_k l_k',  rho_c = p_c.u / u'Q_c u,  maximise sum_c (p_c.u)^2 /
///   u'Q_c u.
/// Gauss-Newton on u (Kaufman's Hessian rho^2 (Q - Quu'Q / u'Qu)) with the gauge sum(u) held, lights at zero
/// that want to be negative held there, steps that do not help shortened. Weights come from the signal that a
/// first guess predicts, not from the noisy values themselves.
/// Golub and Pereyra 1973; Kaufman 1975.
class MatteFit {
 public:
  explicit MatteFit(const EstimatorContext& context);

  /// NaN in a value: it is left out. Pixels beyond in.count up to a multiple of kMostLanes are read: the
  /// planes must be padded.
  void fit(const PixelRun& in, const MatteRun& out) const;
  /// Reflectance, misfit and variance at shares that are given (they need not be those of fit()).
  void assess(const PixelRun& in, const MatteRun& inOut) const;

  [[nodiscard]] int lights() const { return m_lights; }
  [[nodiscard]] int shots() const { return m_shots; }
  /// Degrees of freedom that are left: shots less 1 a channel that some light has, lights less 1.
  [[nodiscard]] int freedom() const { return m_freedom; }

 private:
  int m_lights, m_shots;
  int m_freedom = 0;
  MattePlan m_plan;
};

/// Estimator `maximum-likelihood`: MatteFit, model lambert.
class Lambert final : public Estimator {
 public:
  explicit Lambert(const EstimatorContext& context) : m_fit(context) {}
  void estimate(const PixelRun& in, const SolvedRun& out) const override;

 private:
  MatteFit m_fit;
};

}  // namespace swaplight
