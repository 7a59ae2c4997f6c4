#include "core/edit/raster/shape_drawing.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace swaplight {
namespace {

constexpr double kMostSigma = 6;  // pixels, of a blur at full size
// Softer than so many pixels of sigma, a shape is drawn in a smaller picture: that is as smooth, and costs
// neither the time nor the memory of a picture that is a feather larger on all sides. OpenCV's outline is
// half a pixel of that picture too far out: 1/64 of the sigma at most.
constexpr float kMostDrawnSigma = 32;

/// A row of a picture stretched to `size`, between its pixels, as cv::resize does it.
void stretchedRow(const cv::Mat& from, const cv::Size& size, int y, int left, std::vector<float>& out) {
  const auto place = [](int at, int count, int stretched, int& first, int& second) {
    const double exact = (at + .5) * count / stretched - .5;
    const double clamped = std::clamp(exact, 0., count - 1.);
    first = static_cast<int>(clamped);
    second = std::min(first + 1, count - 1);
    return static_cast<float>(clamped - first);
  };
  int top = 0, bottom = 0;
  const float down = place(y, from.rows, size.height, top, bottom);
  for (size_t i = 0; i < out.size(); ++i) {
    int a = 0, b = 0;
    const float across = place(left + static_cast<int>(i), from.cols, size.width, a, b);
    const auto mixed = [&](const float* row) { return row[a] + across * (row[b] - row[a]); };
    const float upper = mixed(from.ptr<float>(top));
    out[i] = upper + down * (mixed(from.ptr<float>(bottom)) - upper);
  }
}

}  // namespace

MaskRaster rasterOf(const cv::Mat& pixels, cv::Point corner, int width, int height) {
  MaskRaster raster(width, height);
  const PixelRect area = intersection({corner.x, corner.y, pixels.cols, pixels.rows}, {0, 0, width, height});
  for (int y = area.y; y < area.bottom(); ++y)
    raster.writeRow(corner.x, y, pixels.cols, pixels.ptr<float>(y - corner.y));
  return raster;
}

float diagonal(int width, int height) {
  return std::hypot(static_cast<float>(width), static_cast<float>(height));
}

MaskRaster stretched(const cv::Mat& pixels, const cv::Size& size, const cv::Point& corner, int width,
                     int height) {
  MaskRaster raster(width, height);
  const PixelRect seen = intersection({corner.x, corner.y, size.width, size.height}, {0, 0, width, height});
  if (seen.empty()) return raster;
  std::vector<float> row(static_cast<size_t>(seen.width));
  for (int y = seen.y; y < seen.bottom(); ++y) {
    stretchedRow(pixels, size, y - corner.y, seen.x - corner.x, row);
    raster.writeRow(seen.x, y, seen.width, row.data());
  }
  return raster;
}

Canvas::Canvas(float wanted, const PixelRect& box, int width, int height)
    : feather(std::clamp(wanted, 0.F, diagonal(width, height))) {
  while (feather / 4 / static_cast<float>(shrink) > kMostDrawnSigma) shrink *= 2;
  const int air = cvCeil(feather) + 2 * shrink;
  area = intersection(box.grown(air), {-air, -air, width + 2 * air, height + 2 * air});
  if (!area.empty()) size = cv::Size((area.width + shrink - 1) / shrink, (area.height + shrink - 1) / shrink);
}

cv::Point Canvas::place(float x, float y) const {
  constexpr float kFarthest = 1e7F;
  const auto fixed = [&](float at, int corner) {
    const float small = (at - static_cast<float>(corner)) / static_cast<float>(shrink) - .5F;
    return cvRound(std::clamp(small, -kFarthest, kFarthest) * (1 << kShift));
  };
  return {fixed(x, area.x), fixed(y, area.y)};
}

MaskRaster Canvas::soften(const cv::Mat& drawn, int width, int height) const {
  cv::Mat pixels;
  drawn.convertTo(pixels, CV_32F, 1 / 255.);
  if (feather > 1) cv::GaussianBlur(pixels, pixels, {}, feather / 4. / shrink, 0, cv::BORDER_CONSTANT);
  if (shrink == 1) return rasterOf(pixels, {area.x, area.y}, width, height);
  return stretched(pixels, {size.width * shrink, size.height * shrink}, {area.x, area.y}, width, height);
}

void blurMask(cv::Mat& pixels, double sigma) {
  int shrink = 1;
  while (sigma / shrink > kMostSigma) shrink *= 2;
  if (shrink == 1) {
    cv::GaussianBlur(pixels, pixels, {}, sigma, 0, cv::BORDER_CONSTANT);
    return;
  }
  const cv::Size size = pixels.size();
  cv::Mat small;
  cv::resize(pixels, small, {(size.width + shrink - 1) / shrink, (size.height + shrink - 1) / shrink}, 0, 0,
             cv::INTER_AREA);
  cv::GaussianBlur(small, small, {}, sigma / shrink, 0, cv::BORDER_CONSTANT);
  cv::resize(small, pixels, size, 0, 0, cv::INTER_LINEAR);
}

}  // namespace swaplight
