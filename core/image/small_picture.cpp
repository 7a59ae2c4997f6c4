#include "core/image/small_picture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace swaplight {

SmallPicture filling(const SmallPicture& picture, int width, int height) {
  if (picture.empty()) return {};
  const cv::Mat all(picture.height, picture.width, CV_8UC4, const_cast<uint8_t*>(picture.rgba.data()));
  const double scale =
      std::max(static_cast<double>(width) / picture.width, static_cast<double>(height) / picture.height);
  const int w = std::clamp(static_cast<int>(std::lround(width / scale)), 1, picture.width);
  const int h = std::clamp(static_cast<int>(std::lround(height / scale)), 1, picture.height);
  SmallPicture shown{width, height,
                     std::vector<uint8_t>(4 * static_cast<size_t>(width) * static_cast<size_t>(height))};
  cv::Mat to(height, width, CV_8UC4, shown.rgba.data());
  cv::resize(all(cv::Rect((picture.width - w) / 2, (picture.height - h) / 2, w, h)), to, to.size(), 0, 0,
             scale < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
  return shown;
}

}  // namespace swaplight
