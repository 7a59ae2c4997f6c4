#include "core/shadow/evidence/guided_mean.h"

#include <opencv2/ximgproc/edge_filter.hpp>

namespace swaplight {

cv::Mat guidedMean(const cv::Mat& x, const cv::Mat& where, const cv::Mat& guide, double radius,
                   const OtherLightsTuning& tuning, const Otherwise& otherwise) {
  const double range = tuning.meanEdge * tuning.ratioEdge;
  const cv::Mat plain[2] = {x.mul(where), where};
  cv::Mat both, filtered[2];
  cv::merge(plain, 2, both);
  cv::ximgproc::dtFilter(guide, both, both, radius, range);
  cv::split(both, filtered);
  const auto& [sum, weight] = filtered;
  return (sum + otherwise.weight * otherwise.value) / (weight + otherwise.weight);
}

}  // namespace swaplight
