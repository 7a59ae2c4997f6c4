#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace swaplight {

/// Log-odds (float pictures) of what a pixel is to a light.
struct LightOdds {
  cv::Mat umbra;  ///< of umbra against penumbra and lit
  cv::Mat lit;    ///< of lit against penumbra and umbra
};

/// Weighs what umbraFeatures() gives: a network of one hidden layer whose weights (umbra_weights.h) were
/// fitted to rendered sets with truth by tests/bench/train_umbra.py. Why a fitted one: what each feature says
/// is physics, but how much a step on one surface counts against a level that bounce may reach has no closed
/// form; and fitted, odds can be made as sure as they are right on sets left out, so that "cannot be told"
/// can be said. A feature that is no number counts as the least of its range.
[[nodiscard]] LightOdds weighUmbra(const std::vector<cv::Mat>& features);

}  // namespace swaplight
