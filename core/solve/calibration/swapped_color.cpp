#include "core/solve/calibration/swapped_color.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/quantile.h"
#include "core/linear/decompositions.h"
#include "core/solve/calibration/swapped_evening.h"
#include "core/solve/model/pixel_sample.h"

namespace swaplight {
namespace {

using Vector3 = Eigen::Vector3d;

constexpr double kMedianOfChi2 = 0.69;  // of two degrees of freedom, over their mean

/// A few pixels: (y1 - y2) / (y1 + y2) a channel, and its variance.
struct Contrast {
  Vector3 value;
  Vector3 precision;  ///< by noise, and by what no noise explains
};

/// One factor of rank one, and how well the contrasts are explained.
struct RankOne {
  Vector3 direction;
  std::vector<double> share;  ///< 2 beta - 1 over the scale
  std::vector<double> error;  ///< of it, by what the fit leaves in the other directions
};

/// The contrast of a group of pixels; nothing where noise hides it.
std::optional<Contrast> contrastOf(const std::array<Rgb, 2>& mean, int count, const Evening& evening,
                                   const NoiseModel& noise, const SwappedColorTuning& tuning) {
  Contrast contrast;
  for (int c = 0; c < 3; ++c) {
    double y[2], variance[2];
    for (size_t j = 0; j < 2; ++j) {
      const double f = evening.factor[j][c];
      y[j] = f * mean[j][c];
      variance[j] = f * f * noise.variance(mean[j][c]) / count;
    }
    const double sum = y[0] + y[1];
    if (!(sum > tuning.minSignal * std::sqrt(variance[0] + variance[1])) || y[0] <= 0 || y[1] <= 0)
      return std::nullopt;
    contrast.value[c] = (y[0] - y[1]) / sum;
    const double noiseOfIt = 4 * (y[0] * y[0] * variance[1] + y[1] * y[1] * variance[0]) / std::pow(sum, 4);
    contrast.precision[c] = 1 / (noiseOfIt + tuning.systematic * tuning.systematic);
  }
  return contrast;
}

std::vector<Contrast> contrastsOf(const ShotSignal& signal, const SwappedColor& swapped, int shots,
                                  const Evening& evening, const NoiseModel& noise,
                                  const SwappedColorTuning& tuning) {
  const PackedRun sample = pixelSample(signal, shots, size_t(tuning.sample));
  const PixelRun& run = sample.run();
  std::vector<Contrast> contrasts;
  for (int first = 0; first + tuning.together <= run.count; first += tuning.together) {
    std::array<Rgb, 2> mean{Rgb(0), Rgb(0)};
    for (size_t j = 0; j < 2; ++j)
      for (int c = 0; c < 3; ++c)
        for (int p = first; p < first + tuning.together; ++p)
          mean[j][c] += run.signal[swapped.shots[j]][c][p] / float(tuning.together);
    if (const auto contrast = contrastOf(mean, tuning.together, evening, noise, tuning))
      contrasts.push_back(*contrast);
  }
  return contrasts;
}

double shareOf(const Contrast& contrast, const Vector3& direction) {
  const Vector3 weighted = direction.cwiseProduct(contrast.precision);
  return weighted.dot(contrast.value) / weighted.dot(direction);
}

/// Alternates between both factors; what does not fit (glossy, moved) counts less: 1 / (1 + chi-square)^2.
RankOne rankOneOf(const std::vector<Contrast>& contrasts, int rounds) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Contrast& contrast : contrasts)
    moments += contrast.precision.mean() * contrast.value * contrast.value.transpose();
  RankOne fit;
  fit.direction = symmetricEigen(moments).vectors.col(2);
  std::vector<double> chi(contrasts.size()), sorted;
  double typical = 1;
  for (int round = 0; round < rounds; ++round) {
    for (size_t j = 0; j < contrasts.size(); ++j) {
      const Vector3 left = contrasts[j].value - shareOf(contrasts[j], fit.direction) * fit.direction;
      chi[j] = left.cwiseAbs2().dot(contrasts[j].precision) / 2;
    }
    sorted = chi;
    typical = std::max(median(std::span(sorted)) / kMedianOfChi2, 1e-9);
    Vector3 products = Vector3::Zero(), squares = Vector3::Constant(1e-30);
    for (size_t j = 0; j < contrasts.size(); ++j) {
      const double share = shareOf(contrasts[j], fit.direction);
      const double weight = 1 / std::pow(1 + chi[j] / typical, 2);
      products += weight * share * contrasts[j].precision.cwiseProduct(contrasts[j].value);
      squares += weight * share * share * contrasts[j].precision;
    }
    fit.direction = products.cwiseQuotient(squares).normalized();
  }
  for (const Contrast& contrast : contrasts) {
    fit.share.push_back(shareOf(contrast, fit.direction));
    fit.error.push_back(std::sqrt(typical / fit.direction.cwiseAbs2().dot(contrast.precision)));
  }
  return fit;
}

/// The scale of d at which the pixels farthest from evenly lit, noise allowed for, are lit by one lamp.
double smallestScale(const RankOne& fit, const SwappedColorTuning& tuning) {
  std::vector<double> sure;
  for (size_t j = 0; j < fit.share.size(); ++j)
    sure.push_back(std::abs(fit.share[j]) - tuning.deviations * fit.error[j]);
  return quantile(std::span(sure), tuning.extreme);
}

/// Of the two directions the one of a colour that a gel can have, which lets through no more than all light;
/// where both are, the one under which the set is nearer to grey on the whole.
SwappedColorLine likelier(const SwappedColorLine& line, const Rgb& light) {
  constexpr float kMost = 1.05F;  // of full light: a gel's number is a little off
  const SwappedColorLine other = line.opposite();
  const auto possible = [](const Rgb& color) { return std::max({color.r, color.g, color.b}) <= kMost; };
  if (possible(line.at(0)) != possible(other.at(0))) return possible(line.at(0)) ? line : other;
  return line.tintOf(0, light) <= other.tintOf(0, light) ? line : other;
}

}  // namespace

SwappedColorLine SwappedColorLine::opposite() const {
  return {known, -direction, most};
}

Rgb SwappedColorLine::at(float position) const {
  const Rgb d = (1 + std::clamp(position, 0.0F, 1.0F) * (most - 1)) * direction;
  return known * (Rgb(1) - d) / (Rgb(1) + d);
}

double SwappedColorLine::tintOf(float position, const Rgb& light) const {
  const Rgb reflectance = light / (known + at(position));
  const double mean = std::log(std::max(double(reflectance.r) * reflectance.g * reflectance.b, 1e-30)) / 3;
  double spread = 0;
  for (int c = 0; c < 3; ++c) spread += std::pow(std::log(std::max(double(reflectance[c]), 1e-10)) - mean, 2);
  return spread;
}

SwappedColorLine swappedColorLine(const Capture& capture, const SwappedColor& swapped,
                                  const ShotSignal& signal, const NoiseModel& noise,
                                  const SwappedColorTuning& tuning) {
  const Evening evening(capture, swapped);
  const std::vector<Contrast> contrasts =
      contrastsOf(signal, swapped, capture.shotCount(), evening, noise, tuning);
  if (contrasts.size() < size_t(tuning.minGroups))
    throw InputError(
        "an unknown colour cannot be estimated: hardly a pixel is bright enough and not clipped in both "
        "photographs; tell the colour");
  const RankOne fit = rankOneOf(contrasts, tuning.rounds);
  SwappedColorLine line;
  line.known = evening.known;
  const double widest = fit.direction.cwiseAbs().maxCoeff();
  const double scale = std::min(smallestScale(fit, tuning), tuning.farthest / widest);
  if (!(scale * widest > tuning.minContrast))
    throw InputError(
        "an unknown colour cannot be estimated: photographs {} and {} do not differ; did the lamps exchange "
        "their gels?",
        swapped.shots[0] + 1, swapped.shots[1] + 1);
  for (int c = 0; c < 3; ++c) line.direction[c] = float(scale * fit.direction[c]);
  line.most = float(tuning.farthest / (scale * widest));
  const std::vector<Rgb> mean = signal.meanSignal();
  return likelier(line, evening.factor[0] * mean[size_t(swapped.shots[0])] +
                            evening.factor[1] * mean[size_t(swapped.shots[1])]);
}

}  // namespace swaplight
