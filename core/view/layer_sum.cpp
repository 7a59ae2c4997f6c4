#include "core/view/layer_sum.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "core/relight/weighted_sum.h"

namespace swaplight {
namespace {

constexpr int kSumRows = 16;
// Reading the remembered sum costs as much as reading one layer: it has to stand for more.
constexpr int kFewestOthers = 2;

bool samePixels(const std::vector<VisibleLayer>& a, const std::vector<VisibleLayer>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const VisibleLayer& x, const VisibleLayer& y) {
    return isSamePicture(x.identity, y.identity) && x.pixels.data == y.pixels.data &&
           x.pixels.width == y.pixels.width && x.pixels.height == y.pixels.height &&
           x.pixels.rowStride == y.pixels.rowStride;
  });
}

WeightedRow rowOf(const VisibleLayer& layer, int channel, int y) {
  return {layer.pixels.row(std::min(channel, layer.pixels.channels - 1), y), layer.factor[channel]};
}

}  // namespace

void LayerSum::set(std::vector<VisibleLayer> layers) {
  if (!samePixels(layers, m_layers)) {
    m_layers = std::move(layers);
    m_changing.clear();
    m_stale.assign(m_layers.size(), 0);
    return;
  }
  std::vector<char> changed(layers.size(), 0);
  bool covered = !m_changing.empty();
  for (size_t i = 0; i < layers.size(); ++i) {
    changed[i] = m_stale[i] != 0 || layers[i].factor != m_layers[i].factor ? 1 : 0;
    if (changed[i] != 0 && covered) covered = m_changing[i] != 0;
  }
  m_layers = std::move(layers);
  m_stale.assign(m_layers.size(), 0);
  if (covered || std::find(changed.begin(), changed.end(), 1) == changed.end()) return;
  m_changing.clear();
  if (std::count(changed.begin(), changed.end(), 0) < kFewestOthers) return;
  m_changing = std::move(changed);
  rememberOthers();
}

void LayerSum::pixelsChanged(const Pyramid& picture) {
  for (size_t i = 0; i < m_layers.size(); ++i)
    if (isSamePicture(m_layers[i].identity, picture.identity())) m_stale[i] = 1;
}

void LayerSum::rememberOthers() {
  const ImageView shape = m_layers.front().pixels;
  if (m_others.width() != shape.width || m_others.height() != shape.height)
    m_others = Image(ImageSpec::rgb(shape.width, shape.height));
  const ImageSpan sum = m_others.span();
  parallelRows(shape.height, kSumRows, [&](int begin, int end) {
    std::vector<WeightedRow> rows;
    for (int y = begin; y < end; ++y)
      for (int c = 0; c < 3; ++c) {
        rows.clear();
        for (size_t i = 0; i < m_layers.size(); ++i)
          if (m_changing[i] == 0 && m_layers[i].factor[c] != 0) rows.push_back(rowOf(m_layers[i], c, y));
        weightedSum(rows, shape.width, sum.row(c, y));
      }
  });
}

void LayerSum::row(int channel, int y, float* out) const {
  std::vector<WeightedRow> rows;
  rows.reserve(m_layers.size() + 1);
  const bool remembered = !m_changing.empty();
  if (remembered) rows.push_back({m_others.view().row(channel, y), 1});
  for (size_t i = 0; i < m_layers.size(); ++i)
    if (m_layers[i].factor[channel] != 0 && (!remembered || m_changing[i] != 0))
      rows.push_back(rowOf(m_layers[i], channel, y));
  weightedSum(rows, m_layers.empty() ? 0 : m_layers.front().pixels.width, out);
}

}  // namespace swaplight
