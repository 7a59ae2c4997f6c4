#include "core/bench/beta_bound.h"

#include <Eigen/Dense>

namespace swaplight {

double betaBound(const LightPlan& plan, const NoiseModel& noise, std::span<const float> beta,
                 const Rgb& rho) {
  const int free = plan.lights - 1;
  const int parameters = 3 + free;
  Eigen::MatrixXd fisher = Eigen::MatrixXd::Zero(parameters, parameters);
  for (int k = 0; k < plan.shots; ++k)
    for (int c = 0; c < 3; ++c) {
      const double last = plan.color(k, free)[c];
      double g = 0;
      for (int i = 0; i < plan.lights; ++i) g += double(plan.color(k, i)[c]) * beta[size_t(i)];
      Eigen::VectorXd j = Eigen::VectorXd::Zero(parameters);
      j[c] = g;
      for (int i = 0; i < free; ++i) j[3 + i] = rho[c] * (plan.color(k, i)[c] - last);
      fisher += j * j.transpose() / double(noise.variance(float(g * rho[c])));
    }
  const Eigen::MatrixXd covariance = fisher.inverse();
  const Eigen::MatrixXd shares = covariance.bottomRightCorner(free, free);
  // The last light's share is one less the others': its variance is that of their sum.
  return (shares.trace() + shares.sum()) / plan.lights;
}

}  // namespace swaplight
