#pragma once

#include "core/shadow/evidence/shadow_evidence.h"

namespace swaplight {

/// The level that divides a light's shadow from what it lights: of all levels the one whose contour runs
/// along the strongest edges that the other lights do not share, with a bonus for long contours. (The
/// histogram alone, as in Otsu's method, tells apart dark walls and bright faces just as well.) Below nearly
/// all pixels where no contour runs along an edge: a light without shadows; above them for a light that gives
/// nothing. `known` as in SetEvidence. `oddsOfLight`, where they are known: of evidenceOfLight(), at any
/// size; a level counts less that leaves in shadow what they call lit, and a little more that holds what
/// they call shadow. (They find it less surely: counted alike, more that is lit was held as well.)
[[nodiscard]] float shadowThreshold(const ShadowEvidence& light, const cv::Mat& known,
                                    const cv::Mat& oddsOfLight = {},
                                    const ShadowThresholdTuning& tuning = {});

/// The level of well-lit pixels: the 95th percentile.
[[nodiscard]] float litLevel(const ShadowEvidence& light, const cv::Mat& known);

}  // namespace swaplight
