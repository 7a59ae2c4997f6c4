#pragma once

#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "core/image/image.h"

namespace swaplight {

/// Pixels of the longer side of the picture that is divided into shadow and light.
inline constexpr int kUmbraLongest = 480;

/// A set's contributions at a small size (see kUmbraLongest), with their noise.
struct SmallSet {
  std::vector<cv::Mat> rgb;      ///< R G B float, a light each
  std::vector<cv::Mat> grey;     ///< their means over the channels
  std::vector<float> brightest;  ///< of each grey picture: its 99th percentile
  cv::Mat totalRgb, total;       ///< sums over the lights
  float totalBrightest = 0;      ///< of the grey sum

  [[nodiscard]] cv::Size size() const { return total.size(); }
};

/// `contributions`: of a solved set, R G B; `size`: of the small pictures.
[[nodiscard]] SmallSet smallSetOf(std::span<const Image> contributions, cv::Size size);

/// The same set, smaller.
[[nodiscard]] SmallSet smallerSetOf(const SmallSet& set, cv::Size size);

/// What the network that tells umbra (umbra_network.h) looks at: kUmbraEvidence float pictures of the small
/// size. All are logarithms over a light's own 99th percentile or that of the sum, so neither the exposure
/// nor how strong the lights are matters:
/// - this light's level, that of all others together, and this light's share of all;
/// - the colour of this light and of all others together (red and blue over green): bounced light has that of
///   the set;
/// - the mean, the highest and the lowest of the other lights' levels: what they show of the surfaces. 0
///   where there is no other light.
[[nodiscard]] std::vector<cv::Mat> umbraEvidence(const SmallSet& set, size_t light);

inline constexpr int kUmbraEvidence = 10;

}  // namespace swaplight
