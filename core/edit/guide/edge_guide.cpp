#include "core/edit/guide/edge_guide.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/base/parallel.h"

namespace swaplight {
namespace {

constexpr int kBand = 32;
/// Added to the light before its logarithm: a step of 8 bits. What is darker has no colour that can be told.
constexpr float kDark = 1 / 256.F;
/// Stops: what shading and texture change within a surface where hardly any noise is seen. By judgement; an
/// edge is followed from half a stop on in one channel (five times this), in the tests.
constexpr float kLeastSpread = 0.1F;
constexpr float kWhole = 3, kNone = 5;   // spreads
constexpr float kSigmaPerMad = 1.4826F;  // of a normal distribution
constexpr float kLeastRadius = 1.5F;     // pixels: nine of them
constexpr int kSamplesAcross = 32;       // of a surface, at most

float medianOf(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

EdgeGuide::EdgeGuide(const SolvedSet& set) : m_stops(sumAtUnitWhite(set)) {
  for (int c = 0; c < 3; ++c) {
    cv::Mat plane(height(), width(), CV_32F, m_stops.plane(c));
    cv::blur(plane, plane, {3, 3}, {-1, -1}, cv::BORDER_REPLICATE);
    parallelRows(height(), kBand, [&](int begin, int end) {
      for (int y = begin; y < end; ++y) {
        float* row = plane.ptr<float>(y);
        for (int x = 0; x < plane.cols; ++x) row[x] = std::log2(std::max(row[x], 0.F) + kDark);
      }
    });
  }
}

EdgeGuide::EdgeGuide(const std::shared_ptr<const SolvedSet>& set) : EdgeGuide(*set) {
  m_set = set;
}

EdgeGuide::Surface EdgeGuide::surfaceAt(float x, float y, float radius) const {
  radius = std::max(radius, kLeastRadius);
  x = std::clamp(x, 0.5F, static_cast<float>(width()) - 0.5F);
  y = std::clamp(y, 0.5F, static_cast<float>(height()) - 0.5F);
  const int step = std::max(1, static_cast<int>(2 * radius) / kSamplesAcross);
  const auto low = [&](float middle) { return std::max(0, static_cast<int>(middle - radius)); };
  const int right = std::min(width() - 1, static_cast<int>(x + radius));
  const int bottom = std::min(height() - 1, static_cast<int>(y + radius));
  std::array<std::vector<float>, 3> samples;
  for (int row = low(y); row <= bottom; row += step)
    for (int column = low(x); column <= right; column += step) {
      const float dx = static_cast<float>(column) + 0.5F - x, dy = static_cast<float>(row) + 0.5F - y;
      if (dx * dx + dy * dy > radius * radius) continue;
      for (int c = 0; c < 3; ++c)
        samples[static_cast<size_t>(c)].push_back(m_stops.view().at(c, column, row));
    }
  Surface surface{};
  for (size_t c = 0; c < 3; ++c) {
    const float middle = medianOf(samples[c]);
    for (float& value : samples[c]) value = std::abs(value - middle);
    surface.middle[c] = middle;
    surface.inverseSpread[c] = 1 / std::max(kSigmaPerMad * medianOf(samples[c]), kLeastSpread);
  }
  return surface;
}

float EdgeGuide::likeness(const Surface& surface, int x, int y) const {
  float farthest = 0;
  for (int c = 0; c < 3; ++c) {
    const auto channel = static_cast<size_t>(c);
    farthest = std::max(farthest, std::abs(m_stops.view().at(c, x, y) - surface.middle[channel]) *
                                      surface.inverseSpread[channel]);
  }
  const float t = std::clamp((kNone - farthest) / (kNone - kWhole), 0.F, 1.F);
  return t * t * (3 - 2 * t);
}

}  // namespace swaplight
