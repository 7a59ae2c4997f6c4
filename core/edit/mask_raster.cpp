#include "core/edit/mask_raster.h"

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

constexpr float kFull = 65535.f;

}  // namespace

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  const int x = std::max(a.x, b.x);
  const int y = std::max(a.y, b.y);
  return {x, y, std::max(0, std::min(a.right(), b.right()) - x),
          std::max(0, std::min(a.bottom(), b.bottom()) - y)};
}

PixelRect enclosing(const PixelRect& a, const PixelRect& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  const int x = std::min(a.x, b.x);
  const int y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.bottom(), b.bottom()) - y};
}

MaskRaster::MaskRaster(int width, int height)
    : m_width(width),
      m_height(height),
      m_tiles(static_cast<size_t>(columns()) * static_cast<size_t>(rows())) {}

float MaskRaster::at(int x, int y) const {
  const auto& tile = m_tiles[tileIndex(x / kTileSize, y / kTileSize)];
  if (!tile) return 0;
  return static_cast<float>(tile->data()[y % kTileSize * kTileSize + x % kTileSize]) / kFull;
}

void MaskRaster::multiplyRow(int x, int y, int count, float* factors) const {
  const auto* tiles = &m_tiles[tileIndex(0, y / kTileSize)];
  for (int done = 0; done < count;) {
    const int column = (x + done) / kTileSize;
    const int within = (x + done) % kTileSize;
    const int here = std::min(count - done, kTileSize - within);
    if (const auto& tile = tiles[column]) {
      const uint16_t* in = tile->data() + y % kTileSize * kTileSize + within;
      for (int i = 0; i < here; ++i) factors[done + i] *= static_cast<float>(in[i]) * (1 / kFull);
    } else {
      std::fill_n(factors + done, here, 0.f);
    }
    done += here;
  }
}

uint16_t* MaskRaster::writableTile(int column, int row) {
  auto& tile = m_tiles[tileIndex(column, row)];
  if (!tile)
    tile = std::make_shared<Tile>(Tile{});
  else if (tile.use_count() > 1)
    tile = std::make_shared<Tile>(*tile);
  return tile->data();
}

void MaskRaster::set(int x, int y, float value) {
  const auto code = static_cast<uint16_t>(std::lround(std::clamp(value, 0.f, 1.f) * kFull));
  if (code == 0 && !m_tiles[tileIndex(x / kTileSize, y / kTileSize)]) return;
  writableTile(x / kTileSize, y / kTileSize)[y % kTileSize * kTileSize + x % kTileSize] = code;
}

PixelRect MaskRaster::bounds() const {
  return difference(MaskRaster(m_width, m_height));
}

PixelRect MaskRaster::difference(const MaskRaster& other) const {
  if (m_width != other.m_width || m_height != other.m_height)
    return {0, 0, std::max(m_width, other.m_width), std::max(m_height, other.m_height)};
  static const Tile nothing{};
  PixelRect area;
  for (int row = 0; row < rows(); ++row)
    for (int column = 0; column < columns(); ++column) {
      const size_t index = tileIndex(column, row);
      if (m_tiles[index] == other.m_tiles[index]) continue;
      const Tile& a = m_tiles[index] ? *m_tiles[index] : nothing;
      const Tile& b = other.m_tiles[index] ? *other.m_tiles[index] : nothing;
      for (int y = 0; y < kTileSize; ++y) {
        const auto* rowA = a.data() + y * kTileSize;
        const auto* rowB = b.data() + y * kTileSize;
        const auto first = std::mismatch(rowA, rowA + kTileSize, rowB).first - rowA;
        if (first == kTileSize) continue;
        int last = kTileSize - 1;
        while (rowA[last] == rowB[last]) --last;
        area = enclosing(area, {column * kTileSize + static_cast<int>(first), row * kTileSize + y,
                                last - static_cast<int>(first) + 1, 1});
      }
    }
  return intersection(area, {0, 0, m_width, m_height});
}

size_t MaskRaster::bytes() const {
  return sizeof(Tile) * static_cast<size_t>(std::count_if(m_tiles.begin(), m_tiles.end(),
                                                          [](const auto& t) { return t != nullptr; }));
}

size_t MaskRaster::bytesBeyond(const MaskRaster& other) const {
  if (m_tiles.size() != other.m_tiles.size()) return bytes();
  size_t count = 0;
  for (size_t i = 0; i < m_tiles.size(); ++i) count += m_tiles[i] && m_tiles[i] != other.m_tiles[i] ? 1 : 0;
  return count * sizeof(Tile);
}

}  // namespace swaplight
