#pragma once

#include "core/solve/estimators/matte_fit.h"
#include "core/solve/model/estimator.h"

namespace swaplight {

/// The dissertation's estimators for two lights in two shots. Both minimise over beta in [0, 1]
///   sum over c of ( C1 g2(beta) - C2 g1(beta) )^2,   gk(beta) = beta l[k][0] + (1 - beta) l[k][1]     (5.7)
/// which removes the reflectance by cross-multiplication (5.6).

/// How beta is found.
enum class BetaSearch {
  BruteForce,  ///< 1001 steps (listing 6.1): the reference
  ClosedForm,  ///< the residual is linear in beta, so its minimum is -(A.B) / (A.A), clamped
};

/// How the reflectance is found once beta is known.
enum class Reflectance {
  Published,  ///< rho = C1 / (g1 + .01) (listing 6.2): one shot, biased
  BothShots,  ///< least squares over both shots: rho = (C1 g1 + C2 g2) / (g1^2 + g2^2)
};

class TwoLights final : public Estimator {
 public:
  TwoLights(const EstimatorContext& context, BetaSearch search, Reflectance reflectance);
  void estimate(const PixelRun& in, const SolvedRun& out) const override;

 private:
  void assess(const PixelRun& in, const SolvedRun& out) const;
  float m_color[2][2][3];
  MatteFit m_fit;  ///< for the quality of the answer
  BetaSearch m_search;
  Reflectance m_reflectance;
};

/// beta of listing 6.1 for one pixel, literally: the search over 0, .001 ... 1.
[[nodiscard]] float betaByBruteForce(const float shot1[3], const float shot2[3], const float color[2][2][3]);

}  // namespace swaplight
