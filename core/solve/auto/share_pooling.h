#pragma once

#include <span>
#include <vector>

#include "core/image/image.h"
#include "core/solve/auto/auto_tuning.h"
#include "core/solve/model/noise_model.h"

namespace swaplight {

/// How far pixels are held to be of one kind.
struct SharePooling {
  int step = 1;           ///< pixels between the 5 x 5 neighbours that are looked at
  float rejectChi2 = 9;   ///< squared difference of beta over its expected noise
  float guideStep = .2F;  ///< difference of the guide; weights fall to nothing at both
  float overlap = 1;  ///< variance of a mean of neighbours over that of independent ones: they were pooled
  float hiddenVariance = .25F;  ///< fraction of it that differences too small to be seen may hide
  bool clampAtZero = false;     ///< the pooled shares are >= 0, sum 1; else they stay signed
};

/// What a pixel's neighbours say of its proportions, where noise hides them: the mean of those that do not
/// differ from it by more than noise explains and are about as bright, each weighted by how well it is known.
/// A pixel moves there by the part of the neighbourhood's variance that is noise: what is left is real
/// (relief, grain of the surface). So nothing happens where the photographs are clear, and edges, in the
/// proportions or in the picture, stay. (The sigma filter, Lee 1983, with Tukey's biweight instead of a step,
/// around the local linear minimum mean square error, Lee 1980; called with steps 1, 2, ... it is the
/// edge-stopping a-trous transform of Dammertz et al. 2010.)
///
/// `shares`: a plane a light, sum 1, signed (cut off at 0 they would have a mean above 0 in a shadow).
/// `variance`: of beta, a plane, > 0. `guide`: a plane. `pooled` (a plane a light) receives the shares,
/// `left` what is left of the variance; neither may be the same memory as the input.
void poolShares(std::span<const ImageSpan> shares, ImageView variance, ImageView guide,
                const SharePooling& options, std::span<const ImageSpan> pooled, ImageSpan left);

/// The planes of an image of shares.
[[nodiscard]] std::vector<ImageSpan> planesOf(Image& shares);

/// SharePooling::guideStep for a guide that is the root of the set's brightness (its noise is the same
/// everywhere, a quarter of the slope of the variance): a part of a bright part of the set, and noise.
[[nodiscard]] float guideStep(ImageView guide, const NoiseModel& noise, const PoolingTuning& tuning = {});

}  // namespace swaplight
