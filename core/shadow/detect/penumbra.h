#pragma once

#include <vector>

#include "core/shadow/evidence/shadow_evidence.h"

namespace swaplight {

struct RefinedVisibility {
  cv::Mat visibility;  ///< 0..1
  cv::Mat told;        ///< 0..1: how much of it rests on what the other lights show
  cv::Mat reached;     ///< 0..1: a surface that turns away, but sees the light here
};

/// How much of one light each pixel sees (32-bit float, 0..1), made exact where the shadow's edge lies on a
/// surface that the other lights show.
///
/// The light's ratio to the other lights knows nothing of the surface's texture. Where it hardly changes from
/// pixel to pixel, and the division into shadow and light says lit, all of the light arrives; from there it
/// is continued into the shadow's edge (Poisson, not across the edges that the other lights show), and the
/// ratio over that is the visibility. Two things make a light fade at an edge, and the other lights tell them
/// apart: they stay as they are where a cast shadow begins, and change where the surface turns away; there
/// the light is dim, but all of it arrives until the surface no longer sees it (less surely where the light
/// does not fade towards there, see FadingLight). In between, and where the other lights show nothing, the
/// visibility stays as it was.
///
/// `visibilities`: of all lights, from visibilityOf.
[[nodiscard]] RefinedVisibility refineVisibility(const SetEvidence& set,
                                                 const std::vector<cv::Mat>& visibilities, size_t light,
                                                 const ShadowTuning& tuning = {});

}  // namespace swaplight
