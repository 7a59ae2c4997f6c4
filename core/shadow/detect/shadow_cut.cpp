#include "core/shadow/detect/shadow_cut.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc/detail/gcgraph.hpp>

namespace swaplight {
namespace {

constexpr float kSure = 5;         // cost of a side that the level rules out
constexpr float kLevelCost = .1f;  // of a unit of the level's logarithm
constexpr float kMiddle = .25f;    // above the threshold: as likely lit as in shadow
constexpr float kSideCost = .3f;   // of a side that edges speak against
constexpr float kPartingCost = 4;  // of neighbours where there is no border
constexpr float kLeastParting = .02f;

}  // namespace

cv::Mat cutShadow(const cv::Mat& level, float threshold, const ShadowSides& sides) {
  const cv::Size size = sides.apart.size();
  if (size.area() == 1) return level < threshold;  // the graph has to have a link
  cv::detail::GCGraph<float> graph(size.area(), 2 * size.area());
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const int pixel = graph.addVtx();
      const float above = level.at<float>(y, x) - threshold;
      float lit = kLevelCost * (above - kMiddle);
      if (above > kSurelyLit) lit = kSure;
      if (above < -kSurelyShadow) lit = -kSure;
      lit -= kSideCost * sides.toShadow.at<float>(y, x);
      graph.addTermWeights(pixel, std::max(lit, 0.f), std::max(-lit, 0.f));
      const auto link = [&](int x2, int y2) {
        const float apart = .5f * (sides.apart.at<float>(y, x) + sides.apart.at<float>(y2, x2));
        const float cost = kPartingCost * std::exp(-apart) + kLeastParting;
        graph.addEdges(pixel, y2 * size.width + x2, cost, cost);
      };
      if (x > 0) link(x - 1, y);
      if (y > 0) link(x, y - 1);
    }
  graph.maxFlow();
  cv::Mat shadow(size, CV_8U);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      shadow.at<uchar>(y, x) = graph.inSourceSegment(y * size.width + x) ? 0 : 255;
  return shadow;
}

}  // namespace swaplight
