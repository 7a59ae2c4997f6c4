#include "core/view/scopes/scopes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>

#include "core/base/parallel.h"

namespace swaplight {
namespace {

constexpr int kBand = 32;
constexpr int kCodes = 256;

ScopeCounts emptyScope(int width, int height) {
  return {width, height, std::vector<uint32_t>(static_cast<size_t>(width) * static_cast<size_t>(height), 0)};
}

/// Counts bands of the sample's rows on several threads, each into counts of its own, and adds those up.
void countRows(int rows, std::vector<uint32_t>& counts,
               const std::function<void(int begin, int end, std::vector<uint32_t>& counts)>& work) {
  std::mutex adding;
  parallelRows(rows, std::max(kBand, (rows + threadCount() - 1) / threadCount()), [&](int begin, int end) {
    std::vector<uint32_t> own(counts.size(), 0);
    work(begin, end, own);
    const std::lock_guard lock(adding);
    for (size_t i = 0; i < counts.size(); ++i) counts[i] += own[i];
  });
}

/// Rec.709's luma of codes 0..255.
int lumaOf(const uint8_t* rgba) {
  return (13933 * rgba[0] + 46871 * rgba[1] + 4732 * rgba[2] + (1 << 15)) >> 16;
}

const uint8_t* codesOfRow(const ScopeSample& sample, int y) {
  return sample.codes.data() + 4 * static_cast<ptrdiff_t>(y) * sample.width();
}

struct ColorDifference {
  float cb, cr;
};
ColorDifference differenceOf(float r, float g, float b) {
  const float luma = 0.2126F * r + 0.7152F * g + 0.0722F * b;
  return {(b - luma) / 1.8556F, (r - luma) / 1.5748F};
}

size_t placeOn(int side, float x, float y) {
  const int column = std::clamp(static_cast<int>(x * static_cast<float>(side)), 0, side - 1);
  const int row = std::clamp(static_cast<int>(y * static_cast<float>(side)), 0, side - 1);
  return static_cast<size_t>(row) * static_cast<size_t>(side) + static_cast<size_t>(column);
}

/// Counts the bins of R, G, B and luminance, each found from its value.
template <typename BinOf>
Histogram linearCounts(const ScopeSample& sample, const Rgb& weights, int bins, const BinOf& binOf) {
  const auto perChannel = static_cast<size_t>(bins);
  std::vector<uint32_t> counts(4 * perChannel, 0);
  countRows(sample.height(), counts, [&](int begin, int end, std::vector<uint32_t>& own) {
    const ImageView pixels = sample.linear.view();
    for (int y = begin; y < end; ++y) {
      const float *r = pixels.row(0, y), *g = pixels.row(1, y), *b = pixels.row(2, y);
      for (int x = 0; x < pixels.width; ++x) {
        ++own[binOf(r[x])];
        ++own[perChannel + binOf(g[x])];
        ++own[2 * perChannel + binOf(b[x])];
        ++own[3 * perChannel + binOf(weights.r * r[x] + weights.g * g[x] + weights.b * b[x])];
      }
    }
  });
  Histogram histogram;
  for (size_t c = 0; c < 4; ++c)
    histogram.counts[c].assign(counts.begin() + static_cast<ptrdiff_t>(c * perChannel),
                               counts.begin() + static_cast<ptrdiff_t>((c + 1) * perChannel));
  return histogram;
}

/// The bin of a place 0..1; NaN counts as 0.
size_t binAt(float place, int bins) {
  const float scaled = place > 0 ? place * static_cast<float>(bins) : 0;
  return static_cast<size_t>(std::min(scaled, static_cast<float>(bins - 1)));
}

}  // namespace

ScopeCounts waveform(const ScopeSample& sample, ScopeChannel channel, int columns) {
  ScopeCounts scope = emptyScope(columns, kCodes);
  std::vector<size_t> columnOf(static_cast<size_t>(sample.width()));
  for (size_t x = 0; x < columnOf.size(); ++x)
    columnOf[x] = x * static_cast<size_t>(columns) / columnOf.size();
  countRows(sample.height(), scope.counts, [&](int begin, int end, std::vector<uint32_t>& own) {
    for (int y = begin; y < end; ++y) {
      const uint8_t* codes = codesOfRow(sample, y);
      for (size_t x = 0; x < columnOf.size(); ++x) {
        const uint8_t* pixel = codes + 4 * x;
        const int code = channel == ScopeChannel::Luma ? lumaOf(pixel) : pixel[static_cast<int>(channel)];
        ++own[static_cast<size_t>(kCodes - 1 - code) * static_cast<size_t>(columns) + columnOf[x]];
      }
    }
  });
  return scope;
}

std::array<float, 2> vectorscopePlace(const Rgb& code) {
  const auto [cb, cr] = differenceOf(code.r, code.g, code.b);
  return {0.5F + cb, 0.5F - cr};
}

ScopeCounts vectorscope(const ScopeSample& sample, int side) {
  ScopeCounts scope = emptyScope(side, side);
  countRows(sample.height(), scope.counts, [&](int begin, int end, std::vector<uint32_t>& own) {
    for (int y = begin; y < end; ++y) {
      const uint8_t* pixel = codesOfRow(sample, y);
      for (int x = 0; x < sample.width(); ++x, pixel += 4) {
        const auto [cb, cr] = differenceOf(pixel[0], pixel[1], pixel[2]);
        ++own[placeOn(side, 0.5F + cb / 255, 0.5F - cr / 255)];
      }
    }
  });
  return scope;
}

ScopeCounts chromaticityScope(const ScopeSample& sample, const glm::mat3& xyzFromRgb, int side,
                              float darkest) {
  ScopeCounts scope = emptyScope(side, side);
  countRows(sample.height(), scope.counts, [&](int begin, int end, std::vector<uint32_t>& own) {
    const ImageView pixels = sample.linear.view();
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < pixels.width; ++x) {
        const glm::vec3 xyz =
            xyzFromRgb * glm::vec3(pixels.at(0, x, y), pixels.at(1, x, y), pixels.at(2, x, y));
        const float sum = xyz.x + xyz.y + xyz.z;
        if (!(xyz.y >= darkest) || !(sum > 0) || std::isinf(sum)) continue;
        ++own[placeOn(side, xyz.x / sum / kScopeLargestX, 1 - xyz.y / sum / kScopeLargestY)];
      }
  });
  return scope;
}

Histogram codeHistogram(const ScopeSample& sample) {
  std::vector<uint32_t> counts(4 * kCodes, 0);
  countRows(sample.height(), counts, [&](int begin, int end, std::vector<uint32_t>& own) {
    for (int y = begin; y < end; ++y) {
      const uint8_t* pixel = codesOfRow(sample, y);
      for (int x = 0; x < sample.width(); ++x, pixel += 4) {
        for (size_t c = 0; c < 3; ++c) ++own[c * kCodes + pixel[c]];
        ++own[3 * kCodes + static_cast<size_t>(lumaOf(pixel))];
      }
    }
  });
  Histogram histogram;
  for (size_t c = 0; c < 4; ++c)
    histogram.counts[c].assign(counts.begin() + static_cast<ptrdiff_t>(c * kCodes),
                               counts.begin() + static_cast<ptrdiff_t>((c + 1) * kCodes));
  return histogram;
}

Histogram stopsHistogram(const ScopeSample& sample, const Rgb& luminanceWeights, float lowest, float highest,
                         int bins) {
  const float scale = 1 / (highest - lowest);
  return linearCounts(sample, luminanceWeights, bins, [&](float value) {
    return binAt(value > 0 ? (std::log2(value / 0.18F) - lowest) * scale : 0, bins);
  });
}

Histogram linearHistogram(const ScopeSample& sample, const Rgb& luminanceWeights, float highest, int bins) {
  const float scale = 1 / highest;
  return linearCounts(sample, luminanceWeights, bins,
                      [&](float value) { return binAt(value * scale, bins); });
}

void addScopeLight(const ScopeCounts& counts, const Rgb& color, float full, uint8_t* rgba) {
  const float scale = 255 / std::log1p(std::max(full, 1.0F));
  const size_t pixels = counts.counts.size();
  for (size_t i = 0; i < pixels; ++i) {
    uint8_t* pixel = rgba + 4 * i;
    pixel[3] = 255;
    if (counts.counts[i] == 0) continue;
    const float light = scale * std::log1p(static_cast<float>(counts.counts[i]));
    for (int c = 0; c < 3; ++c)
      pixel[c] = static_cast<uint8_t>(std::min(255.0F, static_cast<float>(pixel[c]) + color[c] * light));
  }
}

}  // namespace swaplight
