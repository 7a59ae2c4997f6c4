#include "tests/train/packed_set.h"

#include <algorithm>
#include <cmath>

#include "tests/train/path_tracer.h"

namespace training {
namespace {

float percentileOf(std::vector<float> values, double share) {
  const size_t at = size_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(at), values.end());
  return values[at];
}

uint8_t levelOf(float overTop) {
  if (!(overTop > 0)) return 0;
  return uint8_t(std::clamp(std::lround(16 * (std::log2(overTop) - 2) + 255), 0L, 255L));
}

}  // namespace

std::vector<uint8_t> packedSet(int lampCount, size_t pixels, const float* light, const float* seen) {
  std::vector<uint8_t> bytes(sizeof(int32_t));
  std::vector<float> grey(pixels), direct(pixels), open(pixels);
  int32_t lamps = 0;
  for (int i = 0; i < lampCount; ++i) {
    for (size_t p = 0; p < pixels; ++p) {
      const float* const rgb = light + p * kLightFloats + i * 3;
      grey[p] = (rgb[0] + rgb[1] + rgb[2]) / 3;
      direct[p] = seen[p * kSeenFloats + i * 2];
      open[p] = seen[p * kSeenFloats + i * 2 + 1];
    }
    const float top = percentileOf(grey, .99), reach = 1e-5F * percentileOf(open, .99);
    size_t lit = 0;
    for (size_t p = 0; p < pixels; ++p) lit += direct[p] > .5F * open[p] && open[p] > reach;
    if (!(top > 0) || lit < pixels / 50) continue;
    ++lamps;
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < pixels; ++p) bytes.push_back(levelOf(light[p * kLightFloats + i * 3 + c] / top));
    for (size_t p = 0; p < pixels; ++p)
      bytes.push_back(open[p] > reach ? uint8_t(std::lround(255 * std::min(1.F, direct[p] / open[p]))) : 0);
  }
  std::copy_n(reinterpret_cast<const uint8_t*>(&lamps), sizeof lamps, bytes.begin());
  return bytes;
}

}  // namespace training
