#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <vector>

#include "core/set/solved_set.h"

namespace swaplight {

/// A place of the picture, widths of it, x to the right and y up from its middle.
struct PicturePlace {
  double x, y;
};

/// Of a pixel of a small picture.
[[nodiscard]] inline PicturePlace placeOf(int column, int row, const cv::Size& size) {
  return {(column + .5) / size.width - .5, (.5 * size.height - (row + .5)) / size.width};
}

/// What `make` makes of the place, the row and the column of every pixel.
template <typename Pixel, typename Make>
[[nodiscard]] std::vector<Pixel> gridOf(const cv::Size& size, const Make& make) {
  std::vector<Pixel> pixels;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) pixels.push_back(make(placeOf(x, y, size), y, x));
  return pixels;
}

/// A channel of a picture at a smaller size: the mean of what falls into each pixel.
[[nodiscard]] cv::Mat shrunkPlane(const Image& image, int channel, const cv::Size& size);

/// A light, and the sum of the others, as small pictures (32-bit float).
struct SmallLight {
  std::array<cv::Mat, 3> own, others;
  cv::Mat ownGrey, othersGrey;

  /// No other light shines.
  [[nodiscard]] bool alone() const { return !(cv::sum(othersGrey)[0] > 0); }
  /// 0..1: how much of the light is there. Ratios to the other lights are free of texture.
  [[nodiscard]] cv::Mat seen() const;
  /// The same, and bright enough for more than bounced light: where a cone may be.
  [[nodiscard]] cv::Mat lit() const;
  /// log of pictures of the light over those of the others (of the light itself, where it is alone), bounded.
  [[nodiscard]] cv::Mat logRatio(const cv::Mat& ofOwn, const cv::Mat& ofOthers) const;
};

/// `light` is an index of the set's lights; `width`: at most, pixels.
[[nodiscard]] SmallLight smallLight(const SolvedSet& set, size_t light, int width);

}  // namespace swaplight
