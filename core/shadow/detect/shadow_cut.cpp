#include "core/shadow/detect/shadow_cut.h"

#include <cmath>

#include "core/shadow/numeric/cut_graph.h"

namespace swaplight {

cv::Mat cutShadow(const cv::Mat& level, float threshold, const ShadowSides& sides,
                  const ShadowCutTuning& tuning) {
  const cv::Size size = sides.apart.size();
  if (size.area() == 1) return level < threshold;  // nothing beside it
  CutGraph graph(size.area(), 2 * size.area());
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const int pixel = y * size.width + x;
      const float above = level.at<float>(y, x) - threshold;
      float lit = tuning.levelCost * (above - tuning.middle);
      if (above > tuning.surelyLit) lit = tuning.sure;
      if (above < -tuning.surelyShadow) lit = -tuning.sure;
      lit -= tuning.sideCost * sides.toShadow.at<float>(y, x);
      graph.setPull(pixel, lit);
      const auto link = [&](int x2, int y2) {
        const float apart = .5f * (sides.apart.at<float>(y, x) + sides.apart.at<float>(y2, x2));
        graph.link(pixel, y2 * size.width + x2, tuning.partingCost * std::exp(-apart) + tuning.leastParting);
      };
      if (x > 0) link(x - 1, y);
      if (y > 0) link(x, y - 1);
    }
  graph.solve();
  cv::Mat shadow(size, CV_8U);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      shadow.at<uchar>(y, x) = graph.onSourceSide(y * size.width + x) ? 0 : 255;
  return shadow;
}

}  // namespace swaplight
