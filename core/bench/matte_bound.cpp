#include "core/bench/matte_bound.h"

#include <cmath>
#include <limits>

#include "core/linear/decompositions.h"

namespace swaplight {

MatteBound matteBound(const LightingMatrix& lighting, const NoiseModel& noise, float clip,
                      std::span<const float> beta, const Rgb& rho) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const int free = lighting.lights - 1;
  const int parameters = 3 + free;
  Eigen::MatrixXd fisher = Eigen::MatrixXd::Zero(parameters, parameters);
  for (int k = 0; k < lighting.shots; ++k)
    for (int c = 0; c < 3; ++c) {
      const double last = lighting.color(k, free)[c];
      double g = 0;
      for (int i = 0; i < lighting.lights; ++i) g += double(lighting.color(k, i)[c]) * beta[size_t(i)];
      if (g * rho[c] >= double(clip)) continue;
      Eigen::VectorXd j = Eigen::VectorXd::Zero(parameters);
      j[c] = g;
      for (int i = 0; i < free; ++i) j[3 + i] = rho[c] * (lighting.color(k, i)[c] - last);
      fisher += j * j.transpose() / double(noise.variance(float(g * rho[c])));
    }
  for (int c = 0; c < 3; ++c)
    if (fisher(c, c) == 0 && rho[c] == 0) fisher(c, c) = 1e30;  // no light has it: there is nothing to know
  const Eigen::MatrixXd covariance = inverseOf(fisher);
  if (!covariance.allFinite() || !(covariance.diagonal().minCoeff() > 0)) return {kInfinity, kInfinity};

  const Eigen::MatrixXd shares = covariance.bottomRightCorner(free, free);
  MatteBound bound;
  // The last light's share is one less the others': its variance is that of their sum.
  bound.beta = (shares.trace() + shares.sum()) / lighting.lights;
  for (int i = 0; i < lighting.lights; ++i)
    for (int c = 0; c < 3; ++c) {
      Eigen::VectorXd j = Eigen::VectorXd::Zero(parameters);  // of T = beta rho
      j[c] = beta[size_t(i)];
      if (i < free)
        j[3 + i] = rho[c];
      else
        j.tail(free).setConstant(-rho[c]);
      bound.contribution += j.dot(covariance * j);
    }
  return bound;
}

}  // namespace swaplight
