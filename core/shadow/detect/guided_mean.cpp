#include "core/shadow/detect/guided_mean.h"

#include <opencv2/ximgproc/edge_filter.hpp>

#include "core/shadow/detect/other_lights.h"

namespace swaplight {
namespace {

constexpr double kEdge = 3 * kRatioEdge;  // the filter's range

}  // namespace

cv::Mat guidedMean(const cv::Mat& x, const cv::Mat& where, const cv::Mat& guide, double radius,
                   const Otherwise& otherwise) {
  cv::Mat sum, weight;
  cv::ximgproc::dtFilter(guide, x.mul(where), sum, radius, kEdge);
  cv::ximgproc::dtFilter(guide, where, weight, radius, kEdge);
  return (sum + otherwise.weight * otherwise.value) / (weight + otherwise.weight);
}

}  // namespace swaplight
