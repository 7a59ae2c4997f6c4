#include "core/solve/calibration/swap_shares.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>

#include "core/base/quantile.h"
#include "core/linear/decompositions.h"
#include "core/solve/model/pixel_sample.h"

namespace swaplight {
namespace {

using Vector3 = Eigen::Vector3d;

constexpr double kMedianOfChi2 = 0.69;  // of two degrees of freedom, over their mean

/// The contrast of a group of pixels; nothing where noise hides it.
std::optional<SwapContrast> contrastOf(const std::array<Rgb, 2>& mean, int count, const Evening& evening,
                                       const NoiseModel& noise, const SwappedColorTuning& tuning) {
  SwapContrast contrast;
  Vector3 level;
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
    level[c] = std::log(sum);
    contrast.value[c] = (y[0] - y[1]) / sum;
    const double noiseOfIt = 4 * (y[0] * y[0] * variance[1] + y[1] * y[1] * variance[0]) / std::pow(sum, 4);
    contrast.precision[c] = 1 / (noiseOfIt + tuning.systematic * tuning.systematic);
  }
  for (int j = 0; j < 2; ++j)
    contrast.kind[size_t(j)] = int(std::lround((level[2 * j] - level.mean()) / tuning.kindOfSurface));
  return contrast;
}

double shareOf(const SwapContrast& contrast, const Vector3& direction) {
  const Vector3 weighted = direction.cwiseProduct(contrast.precision);
  return weighted.dot(contrast.value) / weighted.dot(direction);
}

}  // namespace

std::vector<SwapContrast> swapContrasts(const ShotSignal& signal, const SwappedColor& swapped, int shots,
                                        const Evening& evening, const NoiseModel& noise,
                                        const SwappedColorTuning& tuning) {
  const PackedRun sample = pixelSample(signal, shots, size_t(tuning.sample));
  const PixelRun& run = sample.run();
  std::vector<SwapContrast> contrasts;
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

SwapShares swapShares(const std::vector<SwapContrast>& contrasts, const SwappedColorTuning& tuning) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const SwapContrast& contrast : contrasts)
    moments += contrast.precision.mean() * contrast.value * contrast.value.transpose();
  SwapShares fit;
  fit.direction = symmetricEigen(moments).vectors.col(2);
  std::vector<double> chi(contrasts.size()), sorted;
  double typical = 1;
  for (int round = 0; round < tuning.rounds; ++round) {
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
  for (const SwapContrast& contrast : contrasts) {
    fit.share.push_back(shareOf(contrast, fit.direction));
    fit.error.push_back(std::sqrt(typical / fit.direction.cwiseAbs2().dot(contrast.precision)));
  }
  return fit;
}

double swapScale(const std::vector<SwapContrast>& contrasts, const SwapShares& shares,
                 const SwappedColorTuning& tuning) {
  std::map<std::array<int, 2>, std::vector<double>> kinds;
  std::vector<double> all;
  for (size_t j = 0; j < contrasts.size(); ++j) {
    const double sure = std::abs(shares.share[j]) - tuning.deviations * shares.error[j];
    kinds[contrasts[j].kind].push_back(sure);
    all.push_back(sure);
  }
  struct Extreme {
    double share;
    double size;  // of its kind
  };
  std::vector<Extreme> extremes;
  double counted = 0;
  for (auto& [kind, sure] : kinds) {
    if (sure.size() < size_t(tuning.minOfKind)) continue;
    extremes.push_back({quantile(std::span(sure), tuning.extreme), double(sure.size())});
    counted += extremes.back().size;
  }
  // Too motley a set to sort by its surfaces.
  if (2 * counted < double(contrasts.size())) return quantile(std::span(all), tuning.extreme);
  // Where no pixel is lit by one lamp alone a kind has no say: its extreme is smaller than surfaces can
  // differ.
  const double largest = std::max_element(extremes.begin(), extremes.end(), [](auto& a, auto& b) {
                           return a.share < b.share;
                         })->share;
  if (!(largest > 0)) return 0;  // nothing differs for sure
  std::erase_if(extremes, [&](const Extreme& each) { return each.share < tuning.kindsDiffer * largest; });
  std::sort(extremes.begin(), extremes.end(), [](auto& a, auto& b) { return a.share < b.share; });
  double left = 0, below = 0;
  for (const Extreme& each : extremes) left += each.size;
  for (const Extreme& each : extremes)
    if ((below += each.size) >= tuning.mostKinds * left) return each.share;
  return extremes.back().share;
}

}  // namespace swaplight
