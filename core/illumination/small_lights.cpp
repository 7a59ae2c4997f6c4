#include "core/illumination/small_lights.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <span>

#include "core/base/parallel.h"
#include "core/base/quantile.h"

namespace swaplight {

SmallLights smallLights(const SolvedSet& set, int width) {
  const int columns = std::min(width, set.width());
  const cv::Size size(columns, std::max(1L, std::lround(1. * set.height() * columns / set.width())));
  std::vector<cv::Mat> planes(3 * set.contributions.size());
  parallelEach(static_cast<int>(planes.size()), [&](int index) {
    const auto k = static_cast<size_t>(index);
    const Image& image = set.contributions[k / 3];
    const cv::Mat plane(image.height(), image.width(), CV_32F,
                        const_cast<float*>(image.plane(static_cast<int>(k % 3))));
    cv::resize(plane, planes[k], size, 0, 0, cv::INTER_AREA);
    planes[k] = cv::max(planes[k], 0);  // other programs' sets may hold less than no light
  });
  SmallLights small;
  for (cv::Mat& color : small.color) color = cv::Mat::zeros(size, CV_32F);
  for (size_t k = 0; k < planes.size(); k += 3) {
    small.light.push_back((planes[k] + planes[k + 1] + planes[k + 2]) / 3);
    for (size_t c = 0; c < 3; ++c) small.color[c] += planes[k + c];
  }
  small.sum = (small.color[0] + small.color[1] + small.color[2]) / 3;
  return small;
}

double quantileOf(const cv::Mat& values, double share) {
  std::vector<float> all(values.begin<float>(), values.end<float>());
  return quantile(std::span(all), share);
}

}  // namespace swaplight
