#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/set/misfit_cause.h"
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

/// What the matte model leaves of a set's photographs, and what each cause would do to it: fitted as often as
/// asked, to what they hold or to that with something planted in it.
class CauseComparison {
 public:
  /// Nothing where the model leaves no freedom, the set is small or the capture so large that comparing would
  /// take longer than solving. `context` and `signal` must live as long.
  [[nodiscard]] static std::optional<CauseComparison> of(const EstimatorContext& context,
                                                         const ShotSignal& signal, const CauseTuning& tuning);

  [[nodiscard]] const EstimatorContext& context() const { return *m_context; }
  [[nodiscard]] const ShotSignal& signal() const { return *m_signal; }
  [[nodiscard]] const MisfitRows& rows() const { return m_rows; }
  /// Less what this cause explains of them.
  [[nodiscard]] MisfitRows rowsWithout(Cause cause, const CauseTuning& tuning) const;
  [[nodiscard]] const std::vector<PixelMisfit>& sample() const { return m_sample; }
  [[nodiscard]] const std::vector<CauseModel>& models() const { return m_models; }
  /// What a model's unknowns do to the rows, a column each.
  [[nodiscard]] const Eigen::MatrixXd& slopesOf(Cause cause) const;

  /// Every cause, fitted to all of `rows`: `explained` and `size`.
  [[nodiscard]] std::vector<CauseEvidence> fitted(const MisfitRows& rows, const CauseTuning& tuning) const;
  /// What each gains where it was not fitted to, too; the best first.
  void compare(const MisfitRows& rows, std::vector<CauseEvidence>& causes, const CauseTuning& tuning) const;

 private:
  CauseComparison(const EstimatorContext& context, const ShotSignal& signal)
      : m_context(&context), m_signal(&signal) {}
  [[nodiscard]] size_t indexOf(Cause cause) const;

  const EstimatorContext* m_context;
  const ShotSignal* m_signal;
  std::vector<PixelMisfit> m_sample;
  PictureParts m_parts;
  MisfitRows m_rows;
  std::vector<CauseModel> m_models;
  std::vector<Eigen::MatrixXd> m_slopes;  // [model]
};

}  // namespace swaplight
