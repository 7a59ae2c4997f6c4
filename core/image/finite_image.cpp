#include "core/image/finite_image.h"

#include <atomic>
#include <cmath>

#include "core/base/parallel.h"

namespace swaplight {
namespace {

constexpr float kLargest = 1e25F;
constexpr int kRowsAtOnce = 64;

}  // namespace

size_t makeFinite(Image& image) {
  std::atomic<size_t> broken = 0;
  for (int c = 0; c < image.channelCount(); ++c)
    parallelRows(image.height(), kRowsAtOnce, [&](int begin, int end) {
      size_t here = 0;
      for (int y = begin; y < end; ++y) {
        float* row = image.span().row(c, y);
        for (int x = 0; x < image.width(); ++x)
          if (!(std::abs(row[x]) <= kLargest)) row[x] = 0, ++here;
      }
      broken += here;
    });
  return broken;
}

}  // namespace swaplight
