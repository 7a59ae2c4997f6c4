#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "core/intake/log_response.h"
#include "core/linear/decompositions.h"

namespace swaplight {
namespace {

constexpr double kSmooth = 10;  // lambda, a hundred pixels: 2 to 20 give the same on four curves
constexpr double kGamma = 2.2;  // from which the response's difference is smooth

/// Debevec and Malik's hat: what is nearly black or white says little.
double hatOf(int level) {
  return std::min(level, kResponseLevels - 1 - level) / (0.5 * kResponseLevels);
}

/// The normal equations of h.
struct ResponseNormal {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(kResponseLevels, kResponseLevels);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(kResponseLevels);
};

/// One pixel in all its exposures; its light is eliminated: what is left are differences between them.
void addPixel(const ResponseSamples& samples, size_t p, ResponseNormal& normal) {
  double weights = 0, shift = 0;
  for (size_t j = 0; j < samples.length; ++j) {
    const int z = samples.level(p, j);
    weights += responseWeight(z);
    shift += responseWeight(z) * (samples.logTime(p, j) - usualLogResponse(z));
  }
  if (!(weights > 0)) return;
  for (size_t j = 0; j < samples.length; ++j) {
    const int z = samples.level(p, j);
    const double w = responseWeight(z);
    normal.b[z] += w * (samples.logTime(p, j) - usualLogResponse(z) - shift / weights);
    normal.a(z, z) += w;
    for (size_t i = 0; i < samples.length; ++i)
      normal.a(z, samples.level(p, i)) -= w * responseWeight(samples.level(p, i)) / weights;
  }
}

void addSmoothness(double pixels, ResponseNormal& normal) {
  for (int z = 1; z + 1 < kResponseLevels; ++z) {
    const double w = kSmooth * pixels / 100 * std::pow(std::max(hatOf(z), 2.0 / kResponseLevels), 2);
    constexpr double kSecond[3] = {1, -2, 1};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) normal.a(z - 1 + i, z - 1 + j) += w * kSecond[i] * kSecond[j];
  }
  normal.a(kResponseLevels / 2, kResponseLevels / 2) +=
      pixels;  // h is 0 in the middle: one light is as good as another
}

}  // namespace

double usualLogResponse(int level) {
  return kGamma * std::log((level + 0.5) / (kResponseLevels - 0.5));
}

double responseWeight(int level) {
  return std::pow(hatOf(level), 2);
}

std::vector<double> debevecResponse(const ResponseSamples& samples) {
  ResponseNormal normal;
  for (size_t p = 0; p < samples.pixels(); ++p) addPixel(samples, p, normal);
  addSmoothness(std::max(double(samples.pixels()), 1.0), normal);
  const Eigen::VectorXd h = solveSymmetric(normal.a, normal.b);
  std::vector<double> g;
  for (int z = 0; z < kResponseLevels; ++z) g.push_back(usualLogResponse(z) + h[z]);
  return g;
}

}  // namespace swaplight
