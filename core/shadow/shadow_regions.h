#pragma once

#include "core/shadow/light_shadows.h"
#include "core/shadow/shadow_evidence.h"
#include "core/shadow/shadow_options.h"

namespace swaplight {

/// Shadow divided from light: how much of the light each pixel sees, 0..1 (32-bit float). Pixels well below
/// and above the threshold are markers, a watershed (Meyer's, as in OpenCV) on the shading divides the rest
/// along its edges, and a guided filter (He, Sun and Tang 2013) on the level makes the border as soft as the
/// penumbra is. Shadows of fewer than `smallest` pixels become lit, holes of fewer become shadow.
[[nodiscard]] cv::Mat visibilityOf(const ShadowEvidence& light, const cv::Mat& known, float threshold,
                                   int smallest);

/// Shadows of fewer pixels are noise in a picture of the size of `known`.
[[nodiscard]] int smallestShadow(const ShadowOptions& options, const cv::Mat& known);

/// How far below the threshold a pixel is surely in shadow, and how far above it surely lit (natural
/// logarithm); between, the edges decide.
inline constexpr float kShadowMargin = .7f;

/// Umbra, penumbra, lit and unknown from the visibility; then morphology: shadows of fewer than `smallest`
/// pixels become lit (in the visibility too), holes of fewer become umbra.
[[nodiscard]] std::vector<ShadowLabel> labelShadows(cv::Mat& visibility, const cv::Mat& known, int smallest);

}  // namespace swaplight
