#pragma once

#include <opencv2/core.hpp>

#include "core/edit/raster/mask_raster.h"

namespace swaplight {

/// A part of a picture of width x height as a mask: float pixels, the first of them at `corner`, which may
/// lie outside.
[[nodiscard]] MaskRaster rasterOf(const cv::Mat& pixels, cv::Point corner, int width, int height);

/// A picture stretched to `size` with its corner somewhere, as a mask: only what is seen of it is made.
[[nodiscard]] MaskRaster stretched(const cv::Mat& pixels, const cv::Size& size, const cv::Point& corner,
                                   int width, int height);

/// Where a shape is drawn: what can be seen of it, with room for what a feather brings in from outside of the
/// picture, `shrink` times smaller.
struct Canvas {
  float feather;  ///< of the picture; beyond its diagonal there is nothing to see of more
  int shrink = 1;
  PixelRect area;  ///< of the picture; may reach beyond it
  cv::Size size;   ///< of what is drawn; empty where nothing is seen

  /// `box`: around the shape, without its feather.
  Canvas(float wanted, const PixelRect& box, int width, int height);
  /// A point of the picture where pixels have their centres at whole numbers, in OpenCV's fixed point of
  /// kShift bits: whatever a file says.
  [[nodiscard]] cv::Point place(float x, float y) const;
  /// 8 bits to 0..1 with a soft edge, as the mask of the picture.
  [[nodiscard]] MaskRaster soften(const cv::Mat& drawn, int width, int height) const;

  static constexpr int kShift = 4;  ///< OpenCV draws at 1/16 of a pixel
};

/// The longest line in a picture, in pixels.
[[nodiscard]] float diagonal(int width, int height);

/// A Gaussian with zeros outside; a wide one is made of a smaller picture.
void blurMask(cv::Mat& pixels, double sigma);

}  // namespace swaplight
