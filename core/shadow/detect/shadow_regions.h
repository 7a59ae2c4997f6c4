#pragma once

#include <span>

#include "core/shadow/detect/shadow_cut.h"
#include "core/shadow/evidence/shadow_evidence.h"
#include "core/shadow/result/light_shadows.h"
#include "core/shadow/result/shadow_options.h"

namespace swaplight {

/// How much of the light each pixel sees, 0..1 (32-bit float), from the division of a smaller picture into
/// `shadow` (255) and light (0; see cutShadow): a watershed (Meyer's, as in OpenCV) on the shading finds the
/// border to the pixel, and a guided filter (He, Sun and Tang 2013) on the level makes it as soft as the
/// penumbra is. Small shadows are removed, but for those that hold one of the pixels `marked`.
[[nodiscard]] cv::Mat visibilityOf(const ShadowEvidence& light, const cv::Mat& shadow, const cv::Mat& known,
                                   int smallest, const ShadowRegionsTuning& tuning = {},
                                   std::span<const cv::Point> marked = {});

/// The pixels of `known` (8-bit) where the division, of a smaller picture, can be told.
[[nodiscard]] cv::Mat toldPixels(const ShadowDivision& division, const cv::Mat& known);

/// Shadows of fewer pixels are noise in a picture of the size of `known`.
[[nodiscard]] int smallestShadow(const ShadowOptions& options, const cv::Mat& known);

/// Morphology of a visibility: shadows of fewer than `smallest` pixels become lit, holes of fewer become
/// umbra, but for those that hold one of the pixels `marked`.
void removeSmallShadows(cv::Mat& visibility, int smallest, const ShadowRegionsTuning& tuning = {},
                        std::span<const cv::Point> marked = {});

/// Umbra, penumbra, lit and unknown from the visibility.
[[nodiscard]] std::vector<ShadowLabel> labelShadows(const cv::Mat& visibility, const cv::Mat& known,
                                                    const ShadowRegionsTuning& tuning = {});

}  // namespace swaplight
