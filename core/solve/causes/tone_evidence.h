#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/solve/causes/cause_context.h"
#include "core/solve/causes/cause_tuning.h"
#include "core/solve/causes/misfit_sample.h"

namespace swaplight {

/// A tone curve as one way of looking at photographs sees it: what they hold, over the light that their
/// colour space says. 1 everywhere and sure: they hold light.
struct ToneEvidence {
  double levelError = 0;     ///< what photographs whose levels are off by 2 % add to the exponent
  double exponent = 1;       ///< the power of light that fits best
  double exponentError = 0;  ///< its standard error, over parts of the picture
  double departure = 0;      ///< largest logarithm of values over light by the best curve of three terms, but
                             ///< for exposure
  double departureError = 0;  ///< its standard error, over parts of the picture
  double explained = 0;       ///< of the misfit's variance, by that curve
  double misfit = 0;          ///< without a curve, RMS, over the sensor's noise and CauseTuning::modelError
};

/// A tone curve of three terms (cause_slopes.h: an exponent, and contrast), fitted to what a model leaves of
/// a sample, beside levels of the photographs that may be off. Its standard errors are those over sixteen
/// parts of the picture, left out in turns (Efron's jackknife), and what the sample cannot show at all.
/// Nothing where too small a part of the picture is in the sample. Throws Stopped.
[[nodiscard]] std::optional<ToneEvidence> toneEvidence(const CauseContext& context,
                                                       const std::vector<PixelMisfit>& sample,
                                                       const Progress& progress, const CauseTuning& tuning);

/// The curve's three terms alone, for toneGain.
[[nodiscard]] Eigen::VectorXd fittedTone(const CauseContext& context, const std::vector<PixelMisfit>& sample,
                                         const CauseTuning& tuning);

}  // namespace swaplight
