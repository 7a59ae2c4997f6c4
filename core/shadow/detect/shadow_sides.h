#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "core/shadow/evidence/shadow_evidence.h"

namespace swaplight {

/// What edges say about which side of a shadow's border a pixel is on: float pictures of the size
/// of LightOdds.
struct ShadowSides {
  cv::Mat toShadow;  ///< above 0: just beyond an edge, on its dark side; below 0: just before one
  cv::Mat apart;     ///< 0 or more: how much here looks like a border, to neighbours of one kind or another
  cv::Mat own = {};  ///< the part of it that is this light's alone: not the outlines of things
};

/// A border of a light's shadow is one of three things. A cast one is a step of the light that the other
/// lights do not have. Where a surface turns away there is none, but the light stops falling: beyond this
/// bend there is bounced light only, however bright. And at the outline of a thing anything may begin.
/// `bright`: of all lights, 1 where a light is bright enough to tell something of the surface.
[[nodiscard]] ShadowSides shadowSides(const SetEvidence& set, const std::vector<cv::Mat>& bright,
                                      size_t light, const ShadowTuning& tuning = {});

/// 1 where a light's level is above its threshold, else 0, for all lights.
[[nodiscard]] std::vector<cv::Mat> brightParts(const SetEvidence& set, const std::vector<float>& thresholds);

}  // namespace swaplight
