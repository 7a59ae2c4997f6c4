#pragma once

#include <vector>

#include "core/shadow/evidence/shadow_evidence.h"

namespace swaplight {

struct FilledShadow {
  /// What the light would add where its shadow lies (R G B float, in units of SetEvidence::white): such that
  /// contribution + (1 - visibility) * direct has no shadow.
  cv::Mat direct;
  /// The visibility again, as exact as the fill where nothing else told it.
  cv::Mat visibility;
};

/// Fills one light's shadow.
///
/// The light's ratio to the other lights varies smoothly over a surface and knows nothing of its texture: it
/// is continued from the lit surroundings into the shadow, not across the edges that the other lights show (a
/// Poisson fill guided by them), and multiplied by those of the other lights that shine around it. Where they
/// are dark too nothing is known of the surface, and the filled contribution itself is continued. What faces
/// away from the light has borders at which the ratio fades out; those are continued as dark as they are. An
/// approximation: objects in the shadow keep their outlines, but not their shape's own shading. `told` as in
/// RefinedVisibility.
[[nodiscard]] FilledShadow fillShadow(const SetEvidence& set, const std::vector<cv::Mat>& visibilities,
                                      const cv::Mat& told, size_t light, const ShadowTuning& tuning = {});

}  // namespace swaplight
