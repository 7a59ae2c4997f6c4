#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/set/solved_set.h"
#include "core/solve/model/lighting_matrix.h"
#include "core/solve/model/noise_model.h"
#include "core/solve/model/pixel_run.h"
#include "core/solve/model/solve_options.h"

namespace swaplight {

/// The planes of a set from pixel `first` on.
[[nodiscard]] SolvedRun runAt(SolvedSet& set, size_t first);

/// beta from the contributions of a run.
void writeBeta(int lights, int count, const SolvedRun& run);

/// What every estimator needs to know of the capture.
struct EstimatorContext {
  LightingMatrix lighting;
  NoiseModel noise;
};

/// One way to tell the lights of a pixel apart. Immutable after construction, used from many threads; all
/// that depends on the capture alone is computed by the constructor.
class Estimator {
 public:
  virtual ~Estimator() = default;
  virtual void estimate(const PixelRun& in, const SolvedRun& out) const = 0;
};

/// An estimator as the person sees it, and how it is made.
struct EstimatorInfo {
  std::string_view name;     ///< as in --solver
  Model model;               ///< what it assumes
  bool standsForModel;       ///< what --model means, where several assume the same
  std::string_view summary;  ///< one line
  bool masks;                ///< copes with NaN in some of a pixel's values
  /// Throws InputError where the estimator does not fit the matrix (some know two lights only).
  std::unique_ptr<Estimator> (*make)(const EstimatorContext& context);
};

/// All estimators, the published ones first.
[[nodiscard]] std::span<const EstimatorInfo> estimators();
/// Throws InputError that lists the known names.
[[nodiscard]] const EstimatorInfo& estimatorInfo(const std::string& name);
/// The estimator that stands for a model.
[[nodiscard]] const EstimatorInfo& estimatorFor(Model model);
}  // namespace swaplight
