#include "core/edit/pool/small_samples.h"

#include <algorithm>

namespace swaplight {
namespace {

// Between two pixels.
struct Between {
  int index;
  float part;
};
Between between(float place, int last) {
  const float inside = std::clamp(place, 0.F, static_cast<float>(last));
  const int index = std::min(static_cast<int>(inside), std::max(last - 1, 0));
  return {index, inside - static_cast<float>(index)};
}

}  // namespace

SmallRow smallRow(int x, int y, const cv::Size& size, const cv::Size& small) {
  const float stepX = static_cast<float>(small.width) / static_cast<float>(size.width);
  const float stepY = static_cast<float>(small.height) / static_cast<float>(size.height);
  return {(static_cast<float>(x) + .5F) * stepX - .5F, (static_cast<float>(y) + .5F) * stepY - .5F, stepX};
}

void sampleRow(const cv::Mat& small, const SmallRow& row, int count, float* out) {
  const Between v = between(row.y, small.rows - 1);
  const auto* above = small.ptr<float>(v.index);
  const auto* below = small.ptr<float>(std::min(v.index + 1, small.rows - 1));
  const int last = small.cols - 1;
  for (int i = 0; i < count; ++i) {
    const Between h = between(row.x + row.step * static_cast<float>(i), last);
    const int next = std::min(h.index + 1, last);
    const float top = above[h.index] + h.part * (above[next] - above[h.index]);
    const float bottom = below[h.index] + h.part * (below[next] - below[h.index]);
    out[i] = top + v.part * (bottom - top);
  }
}

}  // namespace swaplight
