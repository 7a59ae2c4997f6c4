#pragma once

#include "core/solve/model/estimator.h"

namespace swaplight {

/// Model `single`: each pixel is given to the one light whose colours explain it best (smallest
/// noise-weighted residual of y_kc = l_kc rho_c). Right in deep shadow of all other lights; elsewhere a
/// baseline.
class SingleLight final : public Estimator {
 public:
  explicit SingleLight(const EstimatorContext& context) : m_context(context) {}
  void estimate(const PixelRun& in, const SolvedRun& out) const override;

 private:
  EstimatorContext m_context;
};

}  // namespace swaplight
