#include "core/solve/calibration/color_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/quantile.h"
#include "core/linear/decompositions.h"
#include "core/solve/model/chi_square.h"

namespace swaplight {
namespace {

constexpr double kSingular = 1e-3;  // of the largest singular value: a channel that tells no lights apart
constexpr int kTrials = 24;         // values of u that are weighed

/// The lowest z of one light in one channel, and the standard error that noise gives it.
struct Lowest {
  double z = 0, noise = 0;
};

double normalBelow(double x) {
  return 0.5 * std::erfc(-x * M_SQRT1_2);
}

/// Leaves out the blocks that are dark: the rounding of their few codes is no evidence.
void keepBright(const ColorEvidenceTuning& tuning, std::vector<BlockMean>& blocks) {
  std::vector<float> brightness;
  for (const BlockMean& block : blocks) {
    float sum = 0;
    for (const float y : block.values) sum += y;
    brightness.push_back(sum);
  }
  if (blocks.empty()) return;
  std::vector<float> sorted = brightness;
  const double least = tuning.bright * double(quantile(std::span(sorted), .95));
  size_t kept = 0;
  for (size_t j = 0; j < blocks.size(); ++j)
    if (brightness[j] > least) std::swap(blocks[kept++], blocks[j]);
  blocks.resize(kept);
}

/// The lowest of every light of a channel that is blocked somewhere; nothing where the channel cannot tell
/// the lights apart.
void addLowest(const EstimatorContext& context, const ColorEvidenceTuning& tuning,
               const std::vector<BlockMean>& blocks, int channel, std::vector<Lowest>& lowest) {
  const SingularValues svd = singularValues(context.lighting.matrix(channel));
  const Eigen::VectorXd& s = svd.values;
  if (s[0] <= 0 || s[s.size() - 1] < kSingular * s[0]) return;
  const Eigen::MatrixXd inverse = svd.v * s.cwiseInverse().asDiagonal() * svd.u.transpose();
  for (int i = 0; i < context.lighting.lights; ++i) {
    std::vector<Lowest> all;
    for (const BlockMean& block : blocks) {
      double t = 0, effect = 0, noise = 0;
      for (int k = 0; k < context.lighting.shots; ++k) {
        const double y = block.values[size_t(k * 3 + channel)];
        const double a = inverse(i, k);
        t += a * y;
        effect += a * a * y * y;
        noise += a * a * double(context.noise.variance(float(y))) / BlockMisfit::kPixels;
      }
      if (effect > 0) all.push_back({t / std::sqrt(effect), std::sqrt(noise / effect)});
    }
    if (all.size() < size_t(tuning.fewest)) continue;
    const auto at = all.begin() + long(tuning.lowest * double(all.size()));
    std::nth_element(all.begin(), at, all.end(), [](const Lowest& a, const Lowest& b) { return a.z < b.z; });
    at->z += tuning.lowestOfNoise * at->noise;
    // A light that nothing blocks hides any error of its colours.
    if (at->z < tuning.largest) lowest.push_back(*at);
  }
}

/// The density of log `visible` where the colours are wrong by u: seldom they are all that is seen,
/// and it is u but for the chance of few degrees of freedom; or other causes add to it, by any factor. Of
/// what is too little to be seen, that it is no more.
double chanceOf(const ColorEvidenceTuning& tuning, double visible, double u) {
  const double ratio = std::pow(std::max(visible, tuning.unseen) / u, 2);
  const double deviations = normalOfChiSquare(tuning.visibleFreedom, ratio);
  if (visible <= tuning.unseen) return normalBelow(deviations);
  const double slope = std::sqrt(2 * tuning.visibleFreedom);  // of it along log u
  const double alone = slope * std::exp(-.5 * deviations * deviations) / std::sqrt(2 * M_PI);
  const double among = normalBelow(deviations) / std::log(tuning.largest / tuning.smallest);
  return tuning.alone * alone + (1 - tuning.alone) * among;
}

/// The logarithm of the chance of both witnesses where the colours are wrong by u.
double logLikelihood(const ColorEvidenceTuning& tuning, const std::vector<Lowest>& lowest, double visible,
                     double u) {
  double log = 0;
  for (const Lowest& low : lowest)
    log += std::log(std::max(normalBelow(low.z / std::hypot(u, low.noise)), 1e-30));
  return log + std::log(std::max(chanceOf(tuning, visible, u), 1e-30));
}

}  // namespace

std::optional<float> colorUncertaintyByEvidence(const EstimatorContext& context, const ShotSignal& signal,
                                                float visible, const ColorEvidenceTuning& tuning) {
  if (context.lighting.shots < context.lighting.lights) return std::nullopt;
  return colorUncertaintyByEvidence(context, blockMeans(signal, context.lighting.shots, tuning.blocks),
                                    visible, tuning);
}

std::optional<float> colorUncertaintyByEvidence(const EstimatorContext& context,
                                                std::vector<BlockMean> blocks, float visible,
                                                const ColorEvidenceTuning& tuning) {
  if (context.lighting.shots < context.lighting.lights || context.lighting.lights < 2) return std::nullopt;
  keepBright(tuning, blocks);
  std::vector<Lowest> lowest;
  for (int c = 0; c < 3; ++c) addLowest(context, tuning, blocks, c, lowest);
  if (lowest.empty()) return std::nullopt;

  std::array<double, kTrials> logU{}, log{};
  for (size_t j = 0; j < kTrials; ++j) {
    const double part = double(j) / (kTrials - 1);
    logU[j] = std::log(tuning.smallest) + part * std::log(tuning.largest / tuning.smallest);
    log[j] = logLikelihood(tuning, lowest, double(visible), std::exp(logU[j]));
  }
  const double best = *std::max_element(log.begin(), log.end());
  double weights = 0, sum = 0;
  for (size_t j = 0; j < kTrials; ++j) {
    const double weight = std::exp(log[j] - best);
    weights += weight;
    sum += weight * logU[j];
  }
  return float(std::exp(sum / weights));
}

float colorErrorEverywhere(const EstimatorContext& context, const ShotSignal& signal,
                           const ColorEvidenceTuning& tuning, const ColorFitTuning& fit) {
  const MatteFit matte(context);
  if (context.lighting.lights < 2 || matte.freedom() < 1) return 0;
  const std::vector<BlockMisfit> blocks =
      blockMisfits(matte, context.lighting, context.noise, signal, tuning.blocks);
  if (blocks.empty()) return 0;
  std::vector<float> brightness, misfit;
  for (const BlockMisfit& block : blocks) brightness.push_back(block.brightness);
  const double least = tuning.bright * double(quantile(std::span(brightness), .95));
  for (const BlockMisfit& block : blocks)
    if (block.brightness > least) misfit.push_back(block.smooth);
  if (misfit.empty()) return 0;
  return float(fit.absorbed * std::sqrt(std::max(double(quantile(std::span(misfit), tuning.quiet)), 0.0)));
}

}  // namespace swaplight
