#include "core/shadow/result/untold_pixels.h"

#include <algorithm>
#include <cmath>

namespace swaplight {

UntoldPixels::UntoldPixels(const std::vector<ShadowLabel>& labels, int width, float scale)
    : m_width(width), m_height(width > 0 ? static_cast<int>(labels.size()) / width : 0), m_scale(scale) {
  m_untold.reserve(labels.size());
  for (const ShadowLabel label : labels) m_untold.push_back(label == ShadowLabel::Unknown);
  const auto count = static_cast<float>(std::count(m_untold.begin(), m_untold.end(), true));
  if (!labels.empty()) m_share = count / static_cast<float>(labels.size());
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
