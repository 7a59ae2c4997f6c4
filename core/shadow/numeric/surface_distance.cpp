#include "core/shadow/numeric/surface_distance.h"

#include <numbers>
#include <queue>
#include <vector>

namespace swaplight {
namespace {

struct Front {
  float distance;
  cv::Point at;
  bool operator<(const Front& other) const { return distance > other.distance; }  // the nearest on top
};

}  // namespace

cv::Mat surfaceDistance(const cv::Mat& cost, cv::Point from, float most) {
  cv::Mat distance(cost.size(), CV_32F, cv::Scalar(most));
  std::priority_queue<Front> fronts;
  distance.at<float>(from) = 0;
  fronts.push({0, from});
  const cv::Rect picture({0, 0}, cost.size());
  while (!fronts.empty()) {
    const Front front = fronts.top();
    fronts.pop();
    if (front.distance > distance.at<float>(front.at)) continue;  // a shorter way was found since
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const cv::Point next(front.at.x + dx, front.at.y + dy);
        if (!picture.contains(next)) continue;
        const float length = dx != 0 && dy != 0 ? std::numbers::sqrt2_v<float> : 1;
        const float there = front.distance + length * .5F * (cost.at<float>(front.at) + cost.at<float>(next));
        if (there >= distance.at<float>(next)) continue;
        distance.at<float>(next) = there;
        fronts.push({there, next});
      }
  }
  return distance;
}

}  // namespace swaplight
