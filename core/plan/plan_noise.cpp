#include "core/plan/plan_noise.h"

#include <Eigen/Dense>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

#include "core/simd/plane_arena.h"
#include "core/solve/model/estimator.h"

namespace swaplight {
namespace {

constexpr int kMaxUnknowns = kMaxLights + 3;

// No memory is allocated for these: a search evaluates thousands of plans.
using Square =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxUnknowns, kMaxUnknowns>;

// What is known of a pixel before it is photographed, as the inverse of a variance: without it a plan that
// leaves something undetermined would cost infinitely much, and no two of them could be compared.

/// 1 / the mean square of T, see typicalPixels: E[albedo^2] = .286, E[shading^2] = 1 / 12.
constexpr double kContributionPrior = 42;

/// 1 / the variance of rho, an albedo times the shading of all lights together, times the square of their
/// number: that shading is lights / 4 in the mean, see typicalPixels, and rho known no better than that.
constexpr double kReflectancePrior = 16;

double signalOf(const LightingMatrix& lighting, const TypicalPixel& pixel, int shot, int c) {
  double y = 0;
  for (int i = 0; i < lighting.lights; ++i) y += lighting.color(shot, i)[c] * pixel.shading[size_t(i)];
  return y * pixel.albedo[size_t(c)];
}

double varianceOf(const SensorNoise& noise, double y) {
  return y / noise.fullWell + noise.read * noise.read + 1e-12;
}

double powerOf(const TypicalPixel& pixel, int lights) {
  double power = 0;
  for (int i = 0; i < lights; ++i)
    for (double a : pixel.albedo) power += a * a * pixel.shading[size_t(i)] * pixel.shading[size_t(i)];
  return power;
}

/// Covariance of a channel's contributions at a pixel.
Square channelCovariance(const LightingMatrix& lighting, const SensorNoise& noise, const TypicalPixel& pixel,
                         int c, double prior) {
  const int n = lighting.lights;
  Square gram = Square::Zero(n, n);
  for (int k = 0; k < lighting.shots; ++k) {
    const double weight = 1 / varianceOf(noise, signalOf(lighting, pixel, k, c));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= i; ++j) gram(i, j) += weight * lighting.color(k, i)[c] * lighting.color(k, j)[c];
  }
  gram.diagonal().array() += prior;
  return gram.selfadjointView<Eigen::Lower>().llt().solve(Square::Identity(n, n));
}

/// Covariance of (rho, beta), the direction that only scales one against the other included.
Square matteCovariance(const LightingMatrix& lighting, const SensorNoise& noise, const TypicalPixel& pixel,
                       double total) {
  const int n = lighting.lights;
  Square fisher = Square::Zero(n + 3, n + 3);
  for (int c = 0; c < 3; ++c) {
    const double rho = pixel.albedo[size_t(c)] * total;
    for (int k = 0; k < lighting.shots; ++k) {
      const double y = signalOf(lighting, pixel, k, c);
      const double weight = 1 / varianceOf(noise, y);
      const double lit = rho > 0 ? y / rho : 0;
      fisher(c, c) += weight * lit * lit;
      for (int i = 0; i < n; ++i) {
        const double d = weight * rho * lighting.color(k, i)[c];
        fisher(3 + i, c) += d * lit;
        for (int j = 0; j <= i; ++j) fisher(3 + i, 3 + j) += d * rho * lighting.color(k, j)[c];
      }
    }
  }
  const double lights = n;
  for (int c = 0; c < 3; ++c) fisher(c, c) += kReflectancePrior / (lights * lights);
  // 1 / the variance of proportions that may be anything.
  for (int i = 0; i < n; ++i)
    fisher(3 + i, 3 + i) += lights * lights * (lights + 1) / std::max(lights - 1, 1.0);
  return fisher.selfadjointView<Eigen::Lower>().llt().solve(Square::Identity(n + 3, n + 3));
}

}  // namespace

std::vector<TypicalPixel> typicalPixels(int lights, int count) {
  static constexpr std::array<int, kMaxLights + 3> kPrimes{2,  3,  5,  7,  11, 13, 17, 19, 23, 29,
                                                           31, 37, 41, 43, 47, 53, 59, 61, 67};
  std::vector<TypicalPixel> pixels(static_cast<size_t>(count));
  for (int p = 0; p < count; ++p) {
    const auto unit = [&](int dimension) {
      const double x = (p + 1) * std::sqrt(double(kPrimes[size_t(dimension)]));
      return x - std::floor(x);
    };
    TypicalPixel& pixel = pixels[size_t(p)];
    for (int c = 0; c < 3; ++c) pixel.albedo[size_t(c)] = 0.05 + 0.85 * unit(c);
    for (int i = 0; i < lights; ++i) pixel.shading[size_t(i)] = 0.5 * unit(3 + i);
  }
  return pixels;
}

double matteCost(const LightingMatrix& lighting, const SensorNoise& noise,
                 const std::vector<TypicalPixel>& pixels) {
  const int n = lighting.lights;
  double error = 0;
  double power = 0;
  for (const TypicalPixel& pixel : pixels) {
    double total = 0;
    for (int i = 0; i < n; ++i) total += pixel.shading[size_t(i)];
    if (!(total > 0)) continue;
    const Square covariance = matteCovariance(lighting, noise, pixel, total);
    power += powerOf(pixel, n);
    for (int i = 0; i < n; ++i) {
      const double beta = pixel.shading[size_t(i)] / total;
      for (int c = 0; c < 3; ++c) {
        const double rho = pixel.albedo[size_t(c)] * total;
        error += rho * rho * covariance(3 + i, 3 + i) + beta * beta * covariance(c, c) +
                 2 * beta * rho * covariance(3 + i, c);
      }
    }
  }
  return error / power;
}

double transportCost(const LightingMatrix& lighting, const SensorNoise& noise,
                     const std::vector<TypicalPixel>& pixels) {
  double error = 0;
  double power = 0;
  for (const TypicalPixel& pixel : pixels) {
    power += powerOf(pixel, lighting.lights);
    for (int c = 0; c < 3; ++c)
      error += channelCovariance(lighting, noise, pixel, c, kContributionPrior).trace();
  }
  return error / power;
}

PlanNoise predictedNoise(const LightingMatrix& lighting, const SensorNoise& noise,
                         const std::vector<TypicalPixel>& pixels, Model model) {
  const NoiseModel variance{float(noise.read * noise.read), float(1 / noise.fullWell), 0};
  const auto solver = estimatorFor(model).make({lighting, variance});
  const int n = lighting.lights;
  const size_t count = pixels.size();
  PlaneArena planes(count, size_t(3 * lighting.shots + 4 * n));

  // Photograph the pixels and solve them.
  PixelRun shots;
  shots.count = int(count);
  std::mt19937 random(1);
  std::normal_distribution<double> gauss;
  for (int k = 0; k < lighting.shots; ++k)
    for (int c = 0; c < 3; ++c) {
      float* plane = planes.take(0);
      for (size_t p = 0; p < count; ++p) {
        const double y = signalOf(lighting, pixels[p], k, c);
        plane[p] = float(y + gauss(random) * std::sqrt(varianceOf(noise, y)));
      }
      shots.signal[k][c] = plane;
    }
  SolvedRun solved;
  for (int i = 0; i < n; ++i) {
    for (int c = 0; c < 3; ++c) solved.contribution[i][c] = planes.take();
    solved.beta[i] = planes.take();
  }
  solver->estimate(shots, solved);
  writeBeta(n, int(count), solved);

  double error = 0;
  double power = 0;
  double betaError = 0;
  for (size_t p = 0; p < count; ++p) {
    power += powerOf(pixels[p], n);
    const double total = std::accumulate(pixels[p].shading.begin(), pixels[p].shading.begin() + n, 0.0);
    for (int i = 0; i < n; ++i) {
      const double shading = pixels[p].shading[size_t(i)];
      for (int c = 0; c < 3; ++c)
        error += std::pow(double(solved.contribution[i][c][p]) - pixels[p].albedo[size_t(c)] * shading, 2);
      betaError += std::pow(double(solved.beta[i][p]) - shading / total, 2);
    }
  }
  return {std::sqrt(error / power), std::sqrt(betaError / double(n) / double(count))};
}

double clippedFraction(const LightingMatrix& lighting, const std::vector<TypicalPixel>& pixels) {
  size_t clipped = 0;
  for (const TypicalPixel& pixel : pixels) {
    double brightest = 0;
    for (int k = 0; k < lighting.shots; ++k)
      for (int c = 0; c < 3; ++c) brightest = std::max(brightest, signalOf(lighting, pixel, k, c));
    clipped += brightest >= 1;
  }
  return double(clipped) / double(pixels.size());
}

}  // namespace swaplight
