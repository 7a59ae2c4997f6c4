#include "core/view/window_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"
#include "core/simd/simd.h"

namespace swaplight {
namespace {

constexpr int kBand = 24;  // rows: enough that a level row on a band's edge, read twice, costs little

/// How positions along one side of a window fall onto a level's pixels.
struct Axis {
  std::vector<int> first;     ///< the pixel at or before a position, from the lowest one needed
  std::vector<float> weight;  ///< of the pixel after it; empty where pixels are shown as squares
  int low = 0;                ///< the lowest pixel needed
  int count = 0;
  bool oneToOne = true;  ///< position i shows pixel low + i and nothing else

  Axis(double start, double zoom, int length, int limit, bool smooth) {
    std::vector<int> pixel(static_cast<size_t>(length));
    if (smooth) weight.resize(pixel.size());
    for (int i = 0; i < length; ++i) {
      const double center = start + (i + 0.5) / zoom;
      const double at = std::clamp(smooth ? center - 0.5 : center, 0.0, static_cast<double>(limit - 1));
      pixel[static_cast<size_t>(i)] = static_cast<int>(at);
      if (smooth) weight[static_cast<size_t>(i)] = static_cast<float>(at - std::floor(at));
    }
    low = pixel.front();
    count = std::min(pixel.back() + (smooth ? 2 : 1), limit) - low;
    first = std::move(pixel);
    for (int& p : first) p -= low;
    for (size_t i = 0; oneToOne && i < first.size(); ++i)
      oneToOne = first[i] == static_cast<int>(i) && (!smooth || weight[i] == 0);
  }
};

SWAPLIGHT_SIMD(void, blendRows, (const float* a, const float* b, float weight, int count, float* out),
               (a, b, weight, count, out)) {
  for (int i = 0; i < count; ++i) out[i] = a[i] + weight * (b[i] - a[i]);
}

SWAPLIGHT_SIMD(void, interpolateRow,
               (const float* in, const int* first, const float* weight, int last, int count, float* out),
               (in, first, weight, last, count, out)) {
  for (int i = 0; i < count; ++i) {
    const int next = std::min(first[i] + 1, last);
    out[i] = in[first[i]] + weight[i] * (in[next] - in[first[i]]);
  }
}

struct RgbRow {
  std::array<std::vector<float>, 3> channel;
  explicit RgbRow(int count) {
    for (std::vector<float>& values : channel) values.resize(static_cast<size_t>(count));
  }
};

/// Makes the rows of a window one after the other, for one thread.
class RowMaker {
 public:
  RowMaker(const LayerSum& layers, const Axis& x, const Axis& y, int width)
      : m_layers(layers),
        m_x(x),
        m_y(y),
        m_width(width),
        m_cache{RgbRow(x.count), RgbRow(x.count)},
        m_blended(x.count),
        m_row(width) {}

  /// True where row y shows the same pixels as the row made last.
  [[nodiscard]] bool same(int y) const {
    return m_y.weight.empty() && m_made == m_y.first[static_cast<size_t>(y)];
  }

  const RgbRow& make(int y) {
    const int first = m_y.first[static_cast<size_t>(y)];
    m_made = first;
    const RgbRow& upper = sumRow(first);
    const float weight = m_y.weight.empty() ? 0 : m_y.weight[static_cast<size_t>(y)];
    const RgbRow* source = &upper;
    if (weight > 0 && first + 1 < m_y.count) {
      const RgbRow& lower = sumRow(first + 1);
      for (size_t c = 0; c < 3; ++c)
        blendRows(upper.channel[c].data(), lower.channel[c].data(), weight, m_x.count,
                  m_blended.channel[c].data());
      source = &m_blended;
    }
    if (m_x.oneToOne) return *source;
    for (size_t c = 0; c < 3; ++c) spread(source->channel[c].data(), m_row.channel[c].data());
    return m_row;
  }

 private:
  // The layers' sum along a level's row, kept because the next row of the window most likely needs it again.
  const RgbRow& sumRow(int row) {
    const auto slot = static_cast<size_t>(row & 1);
    RgbRow& sum = m_cache[slot];
    if (m_cached[slot] == row) return sum;
    m_cached[slot] = row;
    for (int c = 0; c < 3; ++c) m_layers.row(c, row, sum.channel[static_cast<size_t>(c)].data());
    return sum;
  }

  void spread(const float* in, float* out) const {
    if (m_x.weight.empty())
      for (int i = 0; i < m_width; ++i) out[i] = in[m_x.first[static_cast<size_t>(i)]];
    else
      interpolateRow(in, m_x.first.data(), m_x.weight.data(), m_x.count - 1, m_width, out);
  }

  const LayerSum& m_layers;
  const Axis& m_x;
  const Axis& m_y;
  int m_width;
  std::array<RgbRow, 2> m_cache;
  std::array<int, 2> m_cached{-1, -1};
  RgbRow m_blended;
  RgbRow m_row;
  int m_made = -1;
};

/// Calls use(row number, pixels, whether they are those of the row before in the same band).
template <typename Use>
void forEachRow(std::span<const ViewLayer> layers, const ViewWindow& window, LayerSum& sum, const Use& use) {
  if (layers.empty() || window.width <= 0 || window.height <= 0) return;
  const int level = std::min(nearestLevel(window.zoom), layers.front().picture->levels() - 1);
  const double shrink = std::exp2(-level);
  const double zoom = window.zoom / shrink;
  const bool smooth = !showsSquares(window);
  const ImageView shape = layers.front().picture->level(level);
  const Axis x(window.left * shrink, zoom, window.width, shape.width, smooth);
  const Axis y(window.top * shrink, zoom, window.height, shape.height, smooth);
  std::vector<VisibleLayer> visible;
  for (const ViewLayer& layer : layers)
    visible.emplace_back(layer, layer.picture->level(level).crop(x.low, y.low, x.count, y.count));
  sum.set(std::move(visible));
  parallelRows(window.height, kBand, [&](int begin, int end) {
    RowMaker maker(sum, x, y, window.width);
    for (int row = begin; row < end; ++row) {
      const bool again = row > begin && maker.same(row);
      static const RgbRow none(0);
      use(row, again ? none : maker.make(row), again);
    }
  });
}

}  // namespace

void windowPixels(std::span<const ViewLayer> layers, const ViewWindow& window, const RowCodes& codes,
                  uint8_t* rgba, LayerSum* memory) {
  LayerSum once;
  const size_t bytes = static_cast<size_t>(window.width) * 4;
  forEachRow(layers, window, memory ? *memory : once, [&](int y, const RgbRow& row, bool again) {
    uint8_t* out = rgba + bytes * static_cast<size_t>(y);
    if (again)
      std::copy_n(out - bytes, bytes, out);
    else
      codes(row.channel[0].data(), row.channel[1].data(), row.channel[2].data(), window.width, out);
  });
}

void windowLinear(std::span<const ViewLayer> layers, const ViewWindow& window, ImageSpan out) {
  LayerSum once;
  forEachRow(layers, window, once, [&](int y, const RgbRow& row, bool again) {
    for (int c = 0; c < 3; ++c) {
      const float* in = again ? out.row(c, y - 1) : row.channel[static_cast<size_t>(c)].data();
      std::copy_n(in, window.width, out.row(c, y));
    }
  });
}

}  // namespace swaplight
