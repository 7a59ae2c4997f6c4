#include "core/solve/estimators/matte_slopes.h"

#include <cmath>

namespace swaplight {
namespace {

constexpr float kLeastShare = 1e-4F;  // of a light that is not held at zero

}  // namespace

MatteSlopes matteSlopes(const EstimatorContext& context, const PixelRun& in, const MatteRun& fit, int p,
                        double modelError) {
  const LightingMatrix& lighting = context.lighting;
  const int values = 3 * lighting.shots;
  MatteSlopes slopes{Eigen::VectorXd(values), Eigen::VectorXd(values), Eigen::VectorXd(values),
                     Eigen::MatrixXd::Zero(values, 3 + lighting.lights)};
  for (int k = 0; k < lighting.shots; ++k)
    for (int c = 0; c < 3; ++c) {
      const int row = 3 * k + c;
      const double rho = double(fit.reflectance[c][p]);
      double g = 0;
      for (int i = 0; i < lighting.lights; ++i)
        g += double(lighting.color(k, i)[c]) * double(fit.share[i][p]);
      const double predicted = g * rho;
      const double w = 1 / std::sqrt(double(context.noise.variance(float(predicted))) +
                                     std::pow(modelError * predicted, 2));
      slopes.predicted[row] = predicted;
      slopes.weight[row] = w;
      slopes.residual[row] = w * (double(in.signal[k][c][p]) - predicted);
      slopes.own(row, c) = w * g;
      for (int i = 0; i < lighting.lights; ++i)
        if (fit.share[i][p] > kLeastShare) slopes.own(row, 3 + i) = w * double(lighting.color(k, i)[c]) * rho;
    }
  return slopes;
}

}  // namespace swaplight
