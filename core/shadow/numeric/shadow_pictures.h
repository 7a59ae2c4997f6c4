#pragma once

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/image/image.h"

namespace swaplight {

// 32-bit float pictures of one or three channels, as the search for shadows handles them.

/// A plane of an image, not a copy: to be read only.
inline cv::Mat planeOf(const Image& image, int channel) {
  return {image.height(), image.width(), CV_32F, const_cast<float*>(image.plane(channel))};
}

inline cv::Mat greyOf(const cv::Mat& rgb) {
  cv::Mat grey;
  cv::transform(rgb, grey, cv::Matx13f(1 / 3.f, 1 / 3.f, 1 / 3.f));
  return grey;
}

inline cv::Mat shrunk(const cv::Mat& x, cv::Size size) {
  cv::Mat out;
  cv::resize(x, out, size, 0, 0, cv::INTER_AREA);
  return out;
}

inline cv::Mat grown(const cv::Mat& x, cv::Size size) {
  cv::Mat out;
  cv::resize(x, out, size, 0, 0, cv::INTER_LINEAR);
  return out;
}

/// One channel as three.
inline cv::Mat spread(const cv::Mat& grey) {
  cv::Mat rgb;
  cv::merge(std::vector<cv::Mat>(3, grey), rgb);
  return rgb;
}

/// A mask of 0 and 255 as 0 and 1.
inline cv::Mat asFloat(const cv::Mat& mask) {
  cv::Mat out;
  mask.convertTo(out, CV_32F, 1 / 255.);
  return out;
}

inline cv::Mat clampedToOne(cv::Mat x) {
  cv::min(x, 1, x);
  cv::max(x, 0, x);
  return x;
}

/// Mean of x over the pixels that `mask` (0 or 1) chooses, at a smaller size.
inline cv::Mat meanOver(const cv::Mat& x, const cv::Mat& mask, cv::Size size) {
  const auto as = [&](const cv::Mat& one) { return x.channels() == 3 ? spread(one) : one; };
  cv::Mat weight = shrunk(mask, size);
  cv::max(weight, 1e-6, weight);
  cv::Mat mean;
  cv::divide(shrunk(x.mul(as(mask)), size), as(weight), mean);
  return mean;
}

/// A picture's size divided by a number; one below 1 counts as 1.
inline cv::Size sizeDivided(cv::Size full, double by) {
  const auto side = [by](int pixels) {
    return std::max(1, static_cast<int>(std::lround(pixels / std::max(by, 1.))));
  };
  return {side(full.width), side(full.height)};
}

/// A picture's size divided by a whole number so that no side is longer than `longest` pixels.
inline cv::Size sizeWithin(cv::Size full, int longest) {
  const int shrink = (std::max(full.width, full.height) + longest - 1) / longest;
  return {(full.width + shrink - 1) / shrink, (full.height + shrink - 1) / shrink};
}

/// A size at which what is smooth is solved.
inline cv::Size workingSize(cv::Size full) {
  return sizeWithin(full, 640);
}

/// The pixels not further than `radius` from one, for erosion and dilation.
inline cv::Mat disk(float radius) {
  const int width = 2 * static_cast<int>(std::lround(radius)) + 1;
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {width, width});
}

/// One pixel of a picture whose longer side has 480: lengths in such pixels fit all sizes.
inline float referenceUnit(const cv::Mat& picture) {
  return static_cast<float>(std::max(picture.cols, picture.rows)) / 480;
}

struct Slopes {
  cv::Mat x, y;
};

inline Slopes slopesOf(const cv::Mat& picture) {
  Slopes slopes;
  cv::Sobel(picture, slopes.x, CV_32F, 1, 0, 1, .5, 0, cv::BORDER_REPLICATE);
  cv::Sobel(picture, slopes.y, CV_32F, 0, 1, 1, .5, 0, cv::BORDER_REPLICATE);
  return slopes;
}

inline cv::Mat sizeOf(const Slopes& slopes) {
  cv::Mat size;
  cv::magnitude(slopes.x, slopes.y, size);
  return size;
}

/// What `share` (0..1) of the pixels do not exceed, of all or those that `mask` (8-bit) chooses; 0 where it
/// chooses none.
inline float percentile(const cv::Mat& picture, double share, const cv::Mat& mask = {}) {
  std::vector<float> values;
  values.reserve(picture.total());
  for (int y = 0; y < picture.rows; ++y) {
    const auto* row = picture.ptr<float>(y);
    if (mask.empty())
      values.insert(values.end(), row, row + picture.cols);
    else
      for (int x = 0; x < picture.cols; ++x)
        if (mask.at<uchar>(y, x)) values.push_back(row[x]);
  }
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The logarithm of a picture (R G B), for edges that nothing is continued over; what is dark is all alike.
inline cv::Mat guideOf(const cv::Mat& rgb) {
  cv::Mat guide = rgb + cv::Scalar::all(.01);
  cv::log(guide, guide);
  return guide;
}

}  // namespace swaplight
