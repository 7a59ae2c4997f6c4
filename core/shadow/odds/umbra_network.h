#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace swaplight {

/// What a pixel is to a light, as float pictures.
struct LightOdds {
  cv::Mat umbra;    ///< log-odds of umbra against penumbra and lit
  cv::Mat lit;      ///< log-odds of lit against penumbra and umbra
  cv::Mat visible;  ///< 0..1: how much of the light is seen, as far as the network can tell
};

/// Weighs what umbraEvidence() gives: a network of convolutions over six sizes of the picture (Ronneberger et
/// al., "U-Net", MICCAI 2015), umbra_network.onnx, which tests/train taught by rendered sets with truth. Why
/// one that is taught: whether a dark wall is far from the light or behind something is told by its shape, by
/// what stands beside it and by what the other lights show there, and no single number says so.
[[nodiscard]] LightOdds weighUmbra(const std::vector<cv::Mat>& evidence);

}  // namespace swaplight
