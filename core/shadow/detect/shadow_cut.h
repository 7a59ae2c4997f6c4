#pragma once

#include <opencv2/core.hpp>

#include "core/shadow/detect/shadow_sides.h"
#include "core/shadow/odds/umbra_network.h"

namespace swaplight {

/// Shadow (255) cut from light (0), 8-bit, at the size of `sides`: the cut that costs least, where pixels pay
/// for a side that their level and the edges beside them speak against, and neighbours for being parted where
/// nothing looks like a border (minimum cut, Boykov and Jolly, "Interactive graph cuts", ICCV 2001).
/// `level`: of ShadowEvidence, at that size. `word`: of wordOfMarks(), at that size; it weighs more than
/// anything else, and where it is near -1 or 1 there is no choice (the seeds of Boykov and Jolly).
[[nodiscard]] cv::Mat cutShadow(const cv::Mat& level, float threshold, const ShadowSides& sides,
                                const cv::Mat& word = {}, const ShadowTuning& tuning = {});

/// Log-odds that the light arrives: the mean of what lit and umbra have. Empty where the odds are.
[[nodiscard]] cv::Mat evidenceOfLight(const LightOdds& odds);

/// The same by odds of umbra and of lit, and what may be a border: `apart` of ShadowSides.
[[nodiscard]] cv::Mat cutShadow(const LightOdds& odds, const cv::Mat& apart,
                                const ShadowCutTuning& tuning = {});

/// One light's picture divided into shadow and light.
struct ShadowDivision {
  cv::Mat shadow;  ///< 8-bit: 255 in shadow, 0 where it is lit
  cv::Mat untold;  ///< 8-bit: 255 where it cannot be told which
  LightOdds odds;  ///< as marks leave them; empty where none were given
};

/// Both cuts made one. A level tells to the pixel where a shadow ends, but of a whole surface whether it is
/// dim or in shadow it knows nothing; the odds know that, and nothing to the pixel. So where the cuts part by
/// no more than the width of a border the level's is taken, and where they part by more that of the odds.
/// Where they are near even it cannot be told, unless most of the light is seen there anyway. Odds of empty
/// pictures say nothing: then the level decides alone. What a person's marks say (`word`, or an empty
/// picture) both cuts obey; where it is strong it is told, and where a weaker one agrees with what the odds
/// say then, less of them is enough.
[[nodiscard]] ShadowDivision divideShadow(const cv::Mat& level, float threshold, const ShadowSides& sides,
                                          const LightOdds& odds, const cv::Mat& word = {},
                                          const ShadowTuning& tuning = {});

}  // namespace swaplight
