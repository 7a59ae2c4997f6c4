#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/intake/log_response.h"
#include "core/linear/decompositions.h"

namespace swaplight {
namespace {

constexpr double kSmoothness = .1;  // lambda, a pixel: .03 to .2 keep three made-up curves within 1 %
constexpr double kDarkest = -4;     // ln of the least response, over that gamma
constexpr int kMiddle = kResponseLevels / 2;

double gammaOf(int level) {
  return std::exp(usualLogResponse(level));
}

/// Robertson's weight, a Gauss around the middle; 0 at the ends, which are clipped.
double gaussOf(int level) {
  constexpr double kHalf = .5 * (kResponseLevels - 1);
  const double gauss = std::exp(-4 * std::pow((level - kHalf) / kHalf, 2));
  return (gauss - std::exp(-4.0)) / (1 - std::exp(-4.0));
}

/// One pixel in all its exposures: sum w (f(z) - t x)^2, with its light x = sum w t f / sum w t^2 put in.
void addLightOf(const ResponseSamples& samples, size_t p, Eigen::MatrixXd& squares) {
  double light = 0;
  for (size_t j = 0; j < samples.length; ++j)
    light += gaussOf(samples.level(p, j)) * std::exp(2 * samples.logTime(p, j));
  if (!(light > 0)) return;
  for (size_t j = 0; j < samples.length; ++j) {
    const int z = samples.level(p, j);
    const double w = gaussOf(z), t = std::exp(samples.logTime(p, j));
    squares(z, z) += w * gammaOf(z) * gammaOf(z);
    for (size_t i = 0; i < samples.length; ++i) {
      const int other = samples.level(p, i);
      squares(z, other) -=
          w * t * gammaOf(z) * gaussOf(other) * std::exp(samples.logTime(p, i)) * gammaOf(other) / light;
    }
  }
}

void addCurvature(double weight, Eigen::MatrixXd& squares) {
  constexpr double kSecond[3] = {1, -2, 1};
  for (int z = 1; z + 1 < kResponseLevels; ++z)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) squares(z - 1 + i, z - 1 + j) += weight * kSecond[i] * kSecond[j];
}

}  // namespace

std::vector<double> robertsonResponse(const ResponseSamples& samples) {
  Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(kResponseLevels, kResponseLevels);
  for (size_t p = 0; p < samples.pixels(); ++p) addLightOf(samples, p, squares);
  addCurvature(kSmoothness * std::max(double(samples.pixels()), 1.0), squares);
  squares(kMiddle, kMiddle) += std::max(double(samples.pixels()), 1.0);  // where u is 1: regular, no other u
  // u'Qu is least, over u that is 1 in the middle: Q u = multiple of that place's unit vector.
  Eigen::VectorXd middle = Eigen::VectorXd::Zero(kResponseLevels);
  middle[kMiddle] = 1;
  Eigen::VectorXd u = solveSymmetric(squares, middle);
  u /= u[kMiddle];
  std::vector<double> g;
  for (int z = 0; z < kResponseLevels; ++z)
    g.push_back(usualLogResponse(z) + std::log(std::max(u[z], std::exp(kDarkest))));
  return g;
}

}  // namespace swaplight
