#include "core/shadow/result/untold_pixels.h"

#include <algorithm>
#include <cmath>

#include "core/shadow/result/label_mask.h"

namespace swaplight {

UntoldPixels::UntoldPixels(const std::vector<ShadowLabel>& labels, int width, float scale)
    : m_width(width), m_height(width > 0 ? static_cast<int>(labels.size()) / width : 0), m_scale(scale) {
  if (labels.empty() || width <= 0) return;
  const cv::Mat untold = untoldMask(labels, width);
  m_untold.assign(untold.begin<uchar>(), untold.end<uchar>());
  const auto count = static_cast<float>(std::count(labels.begin(), labels.end(), ShadowLabel::Unknown));
  m_share = count / static_cast<float>(labels.size());
}

bool UntoldPixels::at(float x, float y) const {
  if (m_share == 0) return false;
  const float column = std::floor(x / m_scale);
  const float row = std::floor(y / m_scale);
  if (!(column >= 0 && row >= 0 && column < static_cast<float>(m_width) &&
        row < static_cast<float>(m_height)))
    return false;
  return m_untold[static_cast<size_t>(row) * static_cast<size_t>(m_width) + static_cast<size_t>(column)];
}

}  // namespace swaplight
