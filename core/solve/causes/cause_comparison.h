#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/set/misfit_cause.h"
#include "core/solve/calibration/block_misfit.h"
#include "core/solve/causes/cause_slopes.h"

namespace swaplight {

/// How many pixels of a capture are held against each other: as many as a pass over them may cost. 0: so many
/// unknowns, or so little freedom, that nothing is said.
[[nodiscard]] int causeSampleSize(const EstimatorContext& context, const CauseTuning& tuning = {});

/// A sample's pixels by the parts of the picture that they lie in: every other part is fitted to in turn.
struct PictureParts {
  std::vector<int> of;  ///< of each pixel: which part, of `count`
  int count = 0;        ///< parts that have pixels
  PixelSpan half[2];    ///< pixels of white parts, and of black ones
  PixelSpan all;
};

/// What the matte model leaves of a set's photographs, and what each cause would do to it.
class CauseComparison {
 public:
  /// Nothing where the model leaves no freedom, the set is small or the capture so large that comparing would
  /// take longer than solving. `context` and `signal` must live as long.
  [[nodiscard]] static std::optional<CauseComparison> of(const EstimatorContext& context,
                                                         const ShotSignal& signal, const CauseTuning& tuning);

  [[nodiscard]] const EstimatorContext& context() const { return *m_context; }
  [[nodiscard]] const ShotSignal& signal() const { return *m_signal; }
  [[nodiscard]] const std::vector<PixelMisfit>& sample() const { return m_sample; }
  [[nodiscard]] const CauseModel& modelOf(Cause cause) const { return m_models[indexOf(cause)]; }
  /// The unknowns of a model that explain most.
  [[nodiscard]] Eigen::VectorXd unknownsOf(Cause cause, const CauseTuning& tuning) const;
  /// Blocks of the photographs, in which negative light is looked for.
  [[nodiscard]] const std::vector<BlockMean>& blocks() const { return m_blocks; }
  /// That of other values of pixels and blocks of these photographs. Nothing where too few are left.
  [[nodiscard]] std::optional<CauseComparison> with(const PlacedPixels& pixels, std::vector<BlockMean> blocks,
                                                    const CauseTuning& tuning) const;

  /// Every cause, fitted to the whole sample: `explained` and `size`.
  [[nodiscard]] std::vector<CauseEvidence> fitted(const CauseTuning& tuning) const;
  /// What each gains where it was not fitted to, too; the best first.
  void compare(std::vector<CauseEvidence>& causes, const CauseTuning& tuning) const;

 private:
  static std::optional<CauseComparison> of(const EstimatorContext& context, const ShotSignal& signal,
                                           std::vector<PixelMisfit> sample, std::vector<BlockMean> blocks,
                                           const CauseTuning& tuning);
  CauseComparison(const EstimatorContext& context, const ShotSignal& signal, std::vector<PixelMisfit> sample,
                  std::vector<BlockMean> blocks, const CauseTuning& tuning);
  [[nodiscard]] size_t indexOf(Cause cause) const;

  const EstimatorContext* m_context;
  const ShotSignal* m_signal;
  std::vector<PixelMisfit> m_sample;
  std::vector<BlockMean> m_blocks;
  PictureParts m_parts;
  MisfitRows m_rows;
  std::vector<CauseModel> m_models;
  std::vector<Eigen::MatrixXd> m_slopes;  // [model]
};

}  // namespace swaplight
