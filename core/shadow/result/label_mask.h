#pragma once

#include <opencv2/core.hpp>

#include "core/shadow/result/shadow_outline.h"

namespace swaplight {

/// 255 where the label is umbra, or penumbra too if that is `lightest`; 0 elsewhere. 8 bits. Where it cannot
/// be told in a line of a pixel's width beside umbra, or of two between umbra and penumbra, that is a border:
/// penumbra.
[[nodiscard]] cv::Mat labelMask(const std::vector<ShadowLabel>& labels, int width, ShadowLabel lightest);

/// 255 where it cannot be told, but for lines of a pixel's width: those are borders.
[[nodiscard]] cv::Mat untoldMask(const std::vector<ShadowLabel>& labels, int width);

/// The closed lines around a mask and around its holes, as in shadowOutlines().
[[nodiscard]] std::vector<Outline> outlinesOfMask(const cv::Mat& mask, float scale, float tolerance);

/// Numbers 1 .. n on the connected shadows (umbra and penumbra, 8 neighbours), 0 elsewhere. 32-bit integers.
[[nodiscard]] cv::Mat shadowRegions(const LightShadows& shadows);

}  // namespace swaplight
