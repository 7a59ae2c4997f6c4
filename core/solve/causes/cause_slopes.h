#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/set/misfit_cause.h"
#include "core/solve/causes/cause_fit.h"
#include "core/solve/causes/misfit_sample.h"

namespace swaplight {

/// A cause as a linear model: what its unknowns, small as they are, do to the values of a pixel.
struct CauseModel {
  Cause cause;
  int unknowns;
  double prior;  ///< standard deviation of an unknown

  /// values x unknowns
  [[nodiscard]] Eigen::MatrixXd change(const PixelMisfit& pixel) const { return slope(*this, pixel); }

  Eigen::MatrixXd (*slope)(const CauseModel&, const PixelMisfit&);
  const EstimatorContext* context;
  const CapturePixels* pixels;
  double typical;  ///< the median pixel's mean value
};

/// Colors: a relative error of every colour in every shot. Ambient: light in every shot alike, behind the
/// reflectance, as a part of the lamps' light or of the same strength everywhere, or added to the values.
/// Tone: y e^(sum a_j t_j(y)), with t = ln y, v - 1 and v^2 - 1 of v = y^(1/2.2): an exponent, and contrast
/// curves (a blend with 3 v^2 - 2 v^3 is exactly that). Moved: each shot but the first shifted, turned and
/// zoomed. Field: each light's colour changed by linear and radial gradients over the picture, in all shots
/// alike. `context` and `signal` must live as long as the models.
[[nodiscard]] std::vector<CauseModel> causeModels(const EstimatorContext& context, const ShotSignal& signal,
                                                  const std::vector<PixelMisfit>& sample);

/// Of Field: what each channel of a light has, in the order of the lights: across, down, outwards.
inline constexpr int kFieldTerms = 3;

/// What a model's unknowns do to the rows of a sample.
[[nodiscard]] Eigen::MatrixXd visibleSlopes(const CauseModel& model, const std::vector<PixelMisfit>& sample,
                                            const MisfitRows& rows);

/// Of Ambient's slopes: white light of the same strength everywhere behind the reflectance, as a part of the
/// median pixel's light.
[[nodiscard]] Eigen::VectorXd evenAmbientSlope(const Eigen::MatrixXd& slopes);

/// How many unknowns the largest model of a capture has.
[[nodiscard]] int mostCauseUnknowns(const LightingMatrix& lighting);

/// The logarithm of the gain that the unknowns of Tone put on a value y (linear, full scale 1).
[[nodiscard]] double toneGain(const Eigen::VectorXd& unknowns, double y);

/// What the unknowns of Moved say of each shot but the first.
struct MovedUnknowns {
  double right, down;  ///< pixels
  double turn;         ///< radians, clockwise as seen
  double zoom;         ///< relative
};
[[nodiscard]] std::vector<MovedUnknowns> movedUnknowns(const CauseModel& model,
                                                       const Eigen::VectorXd& unknowns);

/// CauseEvidence::size of a model's unknowns as they were fitted; of Ambient their RMS.
[[nodiscard]] double causeSize(const CauseModel& model, const Eigen::VectorXd& unknowns,
                               const std::vector<PixelMisfit>& sample);

}  // namespace swaplight
