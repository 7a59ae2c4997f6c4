#pragma once

#include <vector>

#include "core/solve/model/estimator.h"

namespace swaplight {

/// The full demultiplex: T_c = L_c^+ y_c, channel by channel, for any coding of N lights in K >= N shots.
/// Exact for gloss and bounced light. L_c is not positive definite in general (its eigenvalues are plus and
/// minus the DFT magnitudes of rotated colours), so it is never factored itself: the weighted pseudo-inverse
/// is taken by SVD once per capture and channel, singular directions (below 1e-4 of the largest) left at
/// zero. For more shots than lights, shots are weighted by the inverse of their mean noise, which keeps one
/// matrix a capture.
class Demultiplex final : public Estimator {
 public:
  /// How T >= 0 is kept.
  enum class Bound {
    Clamp,         ///< negative values become 0
    LeastSquares,  ///< the least squares over T >= 0, by block principal pivoting (Kim and Park 2011)
  };
  Demultiplex(const EstimatorContext& context, Bound bound);
  void estimate(const PixelRun& in, const SolvedRun& out) const override;

 private:
  void assess(const PixelRun& in, const SolvedRun& out) const;
  void solveBounded(const float* y, int channel, float* x) const;
  int m_lights, m_shots;
  Bound m_bound;
  EstimatorContext m_context;
  std::vector<float> m_inverse[3];   ///< lights x shots
  std::vector<double> m_gram[3];     ///< lights x lights, of the weighted matrix; ridge where singular
  std::vector<double> m_adjoint[3];  ///< lights x shots
};

}  // namespace swaplight
