#include "core/view/display/zebra.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "core/base/parallel.h"

namespace swaplight {
namespace {

constexpr int kBand = 32;
constexpr int kPeriod = 8, kStripe = 4;                       // pixels
constexpr uint32_t kBright = 0xff4040ff, kDark = 0xffff6640;  // A B G R

}  // namespace

void drawZebra(const Zebra& zebra, int width, int height, uint8_t* rgba) {
  const int high = static_cast<int>(std::ceil(255 * zebra.high - 0.5F));
  const int low = static_cast<int>(std::ceil(255 * zebra.low - 0.5F));
  parallelRows(height, kBand, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      uint8_t* row = rgba + 4 * static_cast<ptrdiff_t>(width) * y;
      for (int x = 0; x < width; ++x) {
        uint8_t* pixel = row + 4 * static_cast<ptrdiff_t>(x);
        const int brightest = std::max({pixel[0], pixel[1], pixel[2]});
        if (brightest >= high && ((x + y) & (kPeriod - 1)) < kStripe)
          std::memcpy(pixel, &kBright, 4);
        else if (brightest < low && ((x - y) & (kPeriod - 1)) < kStripe)
          std::memcpy(pixel, &kDark, 4);
      }
    }
  });
}

}  // namespace swaplight
