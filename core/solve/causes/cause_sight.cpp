#include "core/solve/causes/cause_sight.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "core/solve/causes/cause_comparison.h"
#include "core/solve/causes/cause_context.h"
#include "core/solve/causes/cause_evidence.h"
#include "core/solve/causes/cause_rules.h"

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

/// A cause in one of the ways in which it can be planted in a pixel's values.
struct Plant {
  double sign;  ///< of its CauseEvidence::size
  std::function<Eigen::VectorXd(const Eigen::VectorXd& values, const PixelMisfit& fit, double size)> in;
};

/// White light of the same strength everywhere.
Plant ambientPlant(const CauseModel& model) {
  return {1, [&model](const Eigen::VectorXd& values, const PixelMisfit& fit, double size) {
            return Eigen::VectorXd(values + size * evenAmbientSlope(model.change(fit)));
          }};
}

/// An exponent.
Plant tonePlant(double sign) {
  return {sign, [sign](const Eigen::VectorXd& values, const PixelMisfit&, double size) {
            return Eigen::VectorXd(values.array().sign() * values.array().abs().pow(1 + sign * size));
          }};
}

/// Lamps that get redder and less blue, across the picture or down it in turns.
Plant fieldPlant(const CauseModel& model, const std::vector<PixelMisfit>& sample) {
  constexpr Eigen::Index kColorTerms = 3 * kFieldTerms;
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(model.unknowns);
  for (Eigen::Index light = 0; light < unknowns.size() / kColorTerms; ++light) {
    unknowns[light * kColorTerms + light % 2] = 1;                     // red
    unknowns[light * kColorTerms + 2 * kFieldTerms + light % 2] = -1;  // blue
  }
  unknowns /= std::max(causeSize(model, unknowns, sample), 1e-9);
  return {1, [&model, unknowns](const Eigen::VectorXd& values, const PixelMisfit& fit, double size) {
            return Eigen::VectorXd(values + size * (model.change(fit) * unknowns));
          }};
}

/// One that goes unseen is enough.
std::vector<Plant> plantsOf(const CauseComparison& comparison, Cause cause) {
  if (cause == Cause::Tone) return {tonePlant(1), tonePlant(-1)};
  const CauseModel& model = comparison.modelOf(cause);
  if (cause == Cause::Ambient) return {ambientPlant(model)};
  return {fieldPlant(model, comparison.sample())};
}

/// The pixels and blocks of photographs, in which causes are planted.
class Ground {
 public:
  /// `evidence`: before anything is planted. All must live as long.
  Ground(const CauseComparison& comparison, const std::vector<CauseEvidence>& evidence,
         const CauseTuning& tuning)
      : m_comparison(comparison), m_tuning(tuning), m_evidence(evidence) {
    PlacedPixels blocks{PackedRun(shots(), std::max<size_t>(comparison.blocks().size(), 1)), {}};
    for (const BlockMean& block : comparison.blocks()) {
      blocks.values.add(block.values);
      blocks.places.push_back(block.place);
    }
    m_blocks = misfitSample(comparison.context(), comparison.signal(), blocks, tuning);
  }

  /// What the photographs seem to have of a cause already, and may be what goes unsaid. What goes the other
  /// way is something else, behind which it hides: that stays.
  [[nodiscard]] Eigen::VectorXd unsaid(const Plant& plant, Cause cause) const {
    const CauseEvidence* evidence = evidenceOf(cause, m_evidence);
    if (plant.sign * evidence->size > 0) return m_comparison.unknownsOf(cause, m_tuning);
    return Eigen::VectorXd::Zero(m_comparison.modelOf(cause).unknowns);
  }

  /// With a cause of this size in them, less what is `unsaid` of it.
  /// Nothing where too few pixels are left.
  [[nodiscard]] std::optional<CauseComparison> planted(const Plant& plant, Cause cause, double size,
                                                       const Eigen::VectorXd& unsaid) const {
    const CauseModel& model = m_comparison.modelOf(cause);
    const auto values = [&](const PixelMisfit& pixel) {
      return plant.in(pixel.values - model.change(pixel) * unsaid, pixel, size);
    };
    PlacedPixels pixels{PackedRun(shots(), m_comparison.sample().size()), {}};
    for (const PixelMisfit& pixel : m_comparison.sample()) {
      pixels.values.add(values(pixel));
      pixels.places.push_back(placeOf(pixel));
    }
    std::vector<BlockMean> blocks;
    for (const PixelMisfit& block : m_blocks) {
      const Eigen::VectorXf changed = values(block).cast<float>();
      blocks.push_back({placeOf(block), {changed.begin(), changed.end()}});
    }
    return m_comparison.with(pixels, std::move(blocks), m_tuning);
  }

 private:
  [[nodiscard]] int shots() const { return m_comparison.context().lighting.shots; }
  [[nodiscard]] size_t placeOf(const PixelMisfit& pixel) const {
    return size_t(pixel.y) * size_t(m_comparison.signal().pixels().width()) + size_t(pixel.x);
  }

  const CauseComparison& m_comparison;
  const CauseTuning& m_tuning;
  const std::vector<CauseEvidence>& m_evidence;
  std::vector<PixelMisfit> m_blocks;
};

/// The least size that is tried from which on all are said.
std::optional<double> saidFrom(const Ground& ground, const Plant& plant, const SizeRange& range,
                               const CauseTuning& tuning, const Progress& progress) {
  const Eigen::VectorXd unsaid = ground.unsaid(plant, range.cause);
  std::optional<double> from;
  for (double size = range.most; size > range.least; size /= kStep) {
    progress.stopIfAsked();
    const auto planted = ground.planted(plant, range.cause, size, unsaid);
    if (!planted || causesOf(*planted, tuning).likely.empty()) break;
    from = size;
  }
  return from;
}

}  // namespace

std::vector<CauseSight> causeSight(const CauseComparison& comparison, const CauseTuning& tuning,
                                   const Progress& progress) {
  const MisfitCauses causes = causesOf(comparison, tuning);
  if (!causes.likely.empty()) return {};
  const Ground ground(comparison, causes.all, tuning);
  std::vector<CauseSight> sight;
  for (const SizeRange& range : kRanges) {
    CauseSight seen{range.cause, 0.0};
    for (const Plant& plant : plantsOf(comparison, range.cause)) {
      const std::optional<double> from = saidFrom(ground, plant, range, tuning, progress);
      seen.from = seen.from && from ? std::optional(std::max(*seen.from, *from)) : std::nullopt;
    }
    sight.push_back(seen);
  }
  const LightingMatrix& lighting = comparison.context().lighting;
  if (lighting.shots == 2 || lighting.shots < lighting.lights) sight.push_back({Cause::Colors, std::nullopt});
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
