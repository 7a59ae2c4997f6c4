#include "core/intake/response_samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swaplight {
namespace {

constexpr size_t kPixels = 20000;  // of a lighting, about
constexpr float kStep = 16;  // codes: neighbours that differ more are an edge; noise and shading make less

bool isFlat(const std::vector<Image>& codes, size_t first, size_t length, int c, int x, int y) {
  for (size_t k = first; k < first + length; ++k)
    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1)}) {
      const float here = codes[k].view().at(c, x, y), there = codes[k].view().at(c, x + dx, y + dy);
      if (!(std::abs(here - there) * (kResponseLevels - 1) < kStep)) return false;
    }
  return true;
}

uint8_t levelOfCode(float code) {
  constexpr int kLast = kResponseLevels - 1;
  return static_cast<uint8_t>(std::clamp(static_cast<int>(std::lround(code * kLast)), 0, kLast));
}

}  // namespace

std::array<int, kResponseLevels> ResponseSamples::counts() const {
  std::array<int, kResponseLevels> counts{};
  for (const uint8_t one : levels) ++counts[one];
  return counts;
}

ResponseSamples responseSamples(const std::vector<Image>& codes, const Brackets& brackets, int channel) {
  ResponseSamples samples;
  samples.length = static_cast<size_t>(brackets.length);
  int lighting = 0;
  for (size_t first = 0; first + samples.length <= codes.size(); first += samples.length, ++lighting) {
    for (size_t k = first; k < first + samples.length; ++k)
      samples.logTimes.push_back(brackets.stops[k] * std::numbers::ln2);
    const Image& image = codes[first];
    const int step = std::max(1, static_cast<int>(std::sqrt(double(image.pixelCount()) / kPixels)));
    for (int y = 0; y + 1 < image.height(); y += step)
      for (int x = 0; x + 1 < image.width(); x += step) {
        if (!isFlat(codes, first, samples.length, channel, x, y)) continue;
        for (size_t k = first; k < first + samples.length; ++k)
          samples.levels.push_back(levelOfCode(codes[k].view().at(channel, x, y)));
        samples.lighting.push_back(lighting);
      }
  }
  return samples;
}

}  // namespace swaplight
