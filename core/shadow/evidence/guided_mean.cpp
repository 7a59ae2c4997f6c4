#include "core/shadow/evidence/guided_mean.h"

#include <opencv2/ximgproc/edge_filter.hpp>

namespace swaplight {

cv::Mat guidedMean(const cv::Mat& x, const cv::Mat& where, const cv::Mat& guide, double radius,
                   const OtherLightsTuning& tuning, const Otherwise& otherwise) {
  const double range = tuning.meanEdge * tuning.ratioEdge;
  cv::Mat sum, weight;
  cv::ximgproc::dtFilter(guide, x.mul(where), sum, radius, range);
  cv::ximgproc::dtFilter(guide, where, weight, radius, range);
  return (sum + otherwise.weight * otherwise.value) / (weight + otherwise.weight);
}

}  // namespace swaplight
