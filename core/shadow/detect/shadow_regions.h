#pragma once

#include "core/shadow/detect/shadow_evidence.h"
#include "core/shadow/detect/shadow_sides.h"
#include "core/shadow/result/light_shadows.h"
#include "core/shadow/result/shadow_options.h"

namespace swaplight {

/// Shadow divided from light: how much of the light each pixel sees, 0..1 (32-bit float). A cut decides which
/// side is which (see cutShadow), a watershed from there (Meyer's, as in OpenCV) on the shading finds the
/// border to the pixel, and a guided filter (He, Sun and Tang 2013) on the level makes it as soft as the
/// penumbra is. Small shadows are removed.
[[nodiscard]] cv::Mat visibilityOf(const ShadowEvidence& light, const ShadowSides& sides,
                                   const cv::Mat& known, float threshold, int smallest,
                                   const ShadowTuning& tuning = {});

/// Shadows of fewer pixels are noise in a picture of the size of `known`.
[[nodiscard]] int smallestShadow(const ShadowOptions& options, const cv::Mat& known);

/// Morphology of a visibility: shadows of fewer than `smallest` pixels become lit, holes of fewer become
/// umbra.
void removeSmallShadows(cv::Mat& visibility, int smallest, const ShadowRegionsTuning& tuning = {});

/// Umbra, penumbra, lit and unknown from the visibility.
[[nodiscard]] std::vector<ShadowLabel> labelShadows(const cv::Mat& visibility, const cv::Mat& known,
                                                    const ShadowRegionsTuning& tuning = {});

}  // namespace swaplight
