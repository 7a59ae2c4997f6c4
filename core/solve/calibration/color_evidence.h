#pragma once

#include <optional>
#include <vector>

#include "core/solve/calibration/block_misfit.h"
#include "core/solve/calibration/calibration_tuning.h"
#include "core/solve/model/estimator.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {

/// How wrong the light colours are, relative (standard error), by two witnesses.
///
/// No light is negative. What a block of pixels shows of light i in channel c, demultiplexed, is T + e: T >=
/// 0 may be anything, e is what wrong colours do there, of the standard deviation u times the root of the sum
/// of the squared terms that T is the sum of. So z = (T + e) over that root may fall below 0 where the light
/// is blocked. The same colours are wrong everywhere: the lowest blocks of a light and channel, at z less
/// what their own noise lowers them by, are one draw, of the likelihood Phi(z / u). (Of many mixtures of the
/// other lights the worst is taken: u is rather too large, up to about twice.) Where shadows are dark and
/// nothing goes below zero the colours are right, however much the matte model misses: that is bounced light,
/// gloss, or lamps of another hue.
///
/// `visible`, the error of the colours that a fit of them to the photographs finds (colorUncertaintyOf), is
/// the other witness: seldom it is theirs alone, and then u but for chance (chi-square of few
/// degrees of freedom); or other causes add to it. What is too little for the fit to see only says that u is
/// no larger.
///
/// The prior is flat in log u; returns exp of the posterior's mean. `context.noise` is that of the pixels'
/// own (residual_noise.h). Nothing where fewer shots than lights, too few bright blocks, no channel that
/// tells the lights apart, or lights that nothing blocks leave it open.
[[nodiscard]] std::optional<float> colorUncertaintyByEvidence(const EstimatorContext& context,
                                                              const ShotSignal& signal, float visible,
                                                              const ColorEvidenceTuning& tuning = {});

/// The same, of blocks' means.
[[nodiscard]] std::optional<float> colorUncertaintyByEvidence(const EstimatorContext& context,
                                                              std::vector<BlockMean> blocks, float visible,
                                                              const ColorEvidenceTuning& tuning = {});

/// The standard error of the colours that the matte model's misfit asks for everywhere: in the mean of a
/// block noise is averaged out, and while gloss and bounced light are in places, wrong colours are in all of
/// them: the quietest bright blocks count. 0 where the fit leaves no freedom.
[[nodiscard]] float colorErrorEverywhere(const EstimatorContext& context, const ShotSignal& signal,
                                         const ColorEvidenceTuning& tuning = {},
                                         const ColorFitTuning& fit = {});

}  // namespace swaplight
