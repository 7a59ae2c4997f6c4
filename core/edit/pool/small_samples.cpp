#include "core/edit/pool/small_samples.h"

#include <algorithm>
#include <array>

#include "core/edit/pool/small_samples_kernel.h"
#include "core/simd/padding.h"
#include "core/simd/simd.h"

namespace swaplight {
namespace {

constexpr int kBlock = 256;  // pixels of a row

// A place between two pixels, the first of them at `index`.
struct Between {
  int index;
  float part;
};
inline Between between(float place, int last) {
  const float inside = std::min(std::max(place, 0.F), static_cast<float>(last));
  const int index = std::min(static_cast<int>(inside), std::max(last - 1, 0));
  return {index, inside - static_cast<float>(index)};
}

SWAPLIGHT_SIMD(void, mixRows, (const float* above, const float* below, float part, int count, float* out),
               (above, below, part, count, out)) {
  for (int i = 0; i < count; ++i) out[i] = above[i] + part * (below[i] - above[i]);
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
  // Its pixels are no smaller than the row's.
  std::array<float, kBlock + 3 + kSmallRowPadding> mixed;
  std::array<float, roundedUpToLanes(kBlock)> samples;
  for (int begin = 0; begin < count; begin += kBlock) {
    const int block = std::min(kBlock, count - begin);
    const float x = row.x + row.step * static_cast<float>(begin);
    const int from = between(x, last).index;
    // One more, since places may be rounded otherwise there.
    const int to = std::min(between(x + row.step * static_cast<float>(block - 1), last).index + 2, last);
    mixRows(above + from, below + from, v.part, to - from + 1, mixed.data());
    std::fill_n(mixed.data() + (to - from + 1), kSmallRowPadding, 0.F);
    SWAPLIGHT_KERNEL(mixColumns)(mixed.data(), from, last, x, row.step, block, samples.data());
    std::copy_n(samples.data(), block, out + begin);
  }
}

}  // namespace swaplight
