#include "core/solve/causes/cause_sight.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "core/solve/causes/cause_comparison.h"
#include "core/solve/causes/cause_context.h"
#include "core/solve/causes/cause_evidence.h"

namespace swaplight {
namespace {

/// Sizes between which it is sought, as CauseEvidence::size has them.
struct SizeRange {
  Cause cause;
  double least, most;
};

constexpr SizeRange kRanges[] = {{Cause::Ambient, .01, .6}, {Cause::Tone, .02, .5}, {Cause::Field, .005, .2}};
constexpr double kStep = 2;    // between sizes that are tried
constexpr int kPixels = 1000;  // of the sample: what is said of sizes is rough anyway
constexpr int kLights = 2;

/// What a cause of size 1 does to the rows of a sample, to first order.
Eigen::VectorXd slopeOf(const CauseComparison& comparison, Cause cause) {
  const Eigen::MatrixXd& slopes = comparison.slopesOf(cause);
  if (cause == Cause::Ambient) return evenAmbientSlope(slopes);
  if (cause == Cause::Tone) return slopes.col(0);
  constexpr Eigen::Index kColorTerms = 3 * kFieldTerms;
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(slopes.cols());
  for (Eigen::Index light = 0; light < unknowns.size() / kColorTerms; ++light) {
    unknowns[light * kColorTerms + light % 2] = 1;                     // red
    unknowns[light * kColorTerms + 2 * kFieldTerms + light % 2] = -1;  // blue
  }
  const auto model = std::ranges::find(comparison.models(), cause, &CauseModel::cause);
  return slopes * unknowns / std::max(causeSize(*model, unknowns, comparison.sample()), 1e-9);
}

using Plant = std::function<Eigen::VectorXd(double size)>;

/// The ways in which a cause is planted: one that goes unseen is enough.
std::vector<Plant> plantsOf(const CauseComparison& comparison, Cause cause) {
  const Eigen::VectorXd slope = slopeOf(comparison, cause);
  const Plant more = [slope](double size) { return Eigen::VectorXd(size * slope); };
  if (cause != Cause::Tone) return {more};
  return {more, [slope](double size) { return Eigen::VectorXd(-size * slope); }};
}

/// The least size that is tried from which on all are said.
std::optional<double> saidFrom(const CauseComparison& comparison, const MisfitRows& without,
                               const Plant& plant, const SizeRange& range, const CauseTuning& tuning,
                               const Progress& progress) {
  std::optional<double> from;
  for (double size = range.most; size > range.least; size /= kStep) {
    progress.stopIfAsked();
    MisfitRows rows = without;
    rows.residual += plant(size);
    if (causesOf(comparison, rows, tuning).likely.empty()) break;
    from = size;
  }
  return from;
}

}  // namespace

std::vector<CauseSight> causeSight(const CauseComparison& comparison, const CauseTuning& tuning,
                                   const Progress& progress) {
  const LightingMatrix& lighting = comparison.context().lighting;
  if (lighting.lights != kLights || !causesOf(comparison, comparison.rows(), tuning).likely.empty())
    return {};
  std::vector<CauseSight> sight;
  for (const SizeRange& range : kRanges) {
    const MisfitRows without = comparison.rowsWithout(range.cause, tuning);
    CauseSight seen{range.cause, 0.0};
    for (const Plant& plant : plantsOf(comparison, range.cause)) {
      const std::optional<double> from = saidFrom(comparison, without, plant, range, tuning, progress);
      seen.from = seen.from && from ? std::optional(std::max(*seen.from, *from)) : std::nullopt;
    }
    sight.push_back(seen);
  }
  if (lighting.shots == 2) sight.push_back({Cause::Colors, std::nullopt});
  return sight;
}

std::vector<CauseSight> causeSight(const Capture& capture, const CapturePixels& photographs,
                                   const std::optional<SensorNoise>& told, const Progress& progress) {
  const CauseContext context = causeContext(capture, photographs, toldNoise(capture, told));
  CauseTuning tuning;
  tuning.pixels = kPixels;
  const auto comparison = CauseComparison::of(context.estimator, context.signal, tuning);
  return comparison ? causeSight(*comparison, tuning, progress) : std::vector<CauseSight>();
}

}  // namespace swaplight
