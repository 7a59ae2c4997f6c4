#include "core/edit/raster/mask_raster.h"

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

constexpr float kFull = 65535.f;

}  // namespace

MaskRaster::MaskRaster(int width, int height)
    : m_width(width),
      m_height(height),
      m_tiles(static_cast<size_t>(columns()) * static_cast<size_t>(rows())) {}

float MaskRaster::at(int x, int y) const {
  const auto& tile = m_tiles[tileIndex(x / kMaskTile, y / kMaskTile)];
  if (!tile) return 0;
  return static_cast<float>(tile->data()[y % kMaskTile * kMaskTile + x % kMaskTile]) / kFull;
}

void MaskRaster::multiplyRow(int x, int y, int count, float* factors) const {
  const auto* tiles = &m_tiles[tileIndex(0, y / kMaskTile)];
  for (int done = 0; done < count;) {
    const int column = (x + done) / kMaskTile;
    const int within = (x + done) % kMaskTile;
    const int here = std::min(count - done, kMaskTile - within);
    if (const auto& tile = tiles[column]) {
      const uint16_t* in = tile->data() + y % kMaskTile * kMaskTile + within;
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
  if (code == 0 && !m_tiles[tileIndex(x / kMaskTile, y / kMaskTile)]) return;
  writableTile(x / kMaskTile, y / kMaskTile)[y % kMaskTile * kMaskTile + x % kMaskTile] = code;
}

void MaskRaster::writeRow(int x, int y, int count, const float* values) {
  const PixelRect inside = intersection({x, y, count, 1}, {0, 0, m_width, m_height});
  for (int at = inside.x; at < inside.right() && !inside.empty();) {
    const int end = std::min(inside.right(), (at / kMaskTile + 1) * kMaskTile);
    const float* in = values + (at - x);
    const bool filled = std::any_of(in, in + (end - at), [](float v) { return v >= .5f / kFull; });
    if (filled || m_tiles[tileIndex(at / kMaskTile, y / kMaskTile)]) {
      uint16_t* row =
          writableTile(at / kMaskTile, y / kMaskTile) + y % kMaskTile * kMaskTile + at % kMaskTile;
      std::transform(in, in + (end - at), row, [](float v) {
        return static_cast<uint16_t>(std::lrint(std::clamp(v, 0.f, 1.f) * kFull));
      });
    }
    at = end;
  }
}

PixelRect MaskRaster::tileRect(int column, int row) const {
  return intersection({column * kMaskTile, row * kMaskTile, kMaskTile, kMaskTile}, {0, 0, m_width, m_height});
}

PixelRect MaskRaster::bounds() const {
  PixelRect area;
  for (const PixelRect& tile : filledTiles()) area = enclosing(area, tile);
  return area;
}

std::vector<PixelRect> MaskRaster::filledTiles() const {
  std::vector<PixelRect> filled;
  for (int row = 0; row < rows(); ++row)
    for (int column = 0; column < columns(); ++column)
      if (m_tiles[tileIndex(column, row)]) filled.push_back(tileRect(column, row));
  return filled;
}

bool MaskRaster::touches(const PixelRect& area) const {
  const PixelRect inside = intersection(area, {0, 0, m_width, m_height});
  if (inside.empty()) return false;
  for (int row = inside.y / kMaskTile; row <= (inside.bottom() - 1) / kMaskTile; ++row)
    for (int column = inside.x / kMaskTile; column <= (inside.right() - 1) / kMaskTile; ++column)
      if (m_tiles[tileIndex(column, row)]) return true;
  return false;
}

std::vector<PixelRect> MaskRaster::differences(const MaskRaster& other) const {
  if (m_width != other.m_width || m_height != other.m_height)
    return {{0, 0, std::max(m_width, other.m_width), std::max(m_height, other.m_height)}};
  static const Tile nothing{};
  std::vector<PixelRect> areas;
  for (int row = 0; row < rows(); ++row)
    for (int column = 0; column < columns(); ++column) {
      const size_t index = tileIndex(column, row);
      if (m_tiles[index] == other.m_tiles[index]) continue;
      const Tile& a = m_tiles[index] ? *m_tiles[index] : nothing;
      const Tile& b = other.m_tiles[index] ? *other.m_tiles[index] : nothing;
      PixelRect area;
      for (int y = 0; y < kMaskTile; ++y) {
        const auto* rowA = a.data() + y * kMaskTile;
        const auto* rowB = b.data() + y * kMaskTile;
        const auto first = std::mismatch(rowA, rowA + kMaskTile, rowB).first - rowA;
        if (first == kMaskTile) continue;
        int last = kMaskTile - 1;
        while (rowA[last] == rowB[last]) --last;
        area = enclosing(area, {column * kMaskTile + static_cast<int>(first), row * kMaskTile + y,
                                last - static_cast<int>(first) + 1, 1});
      }
      area = intersection(area, {0, 0, m_width, m_height});
      if (!area.empty()) areas.push_back(area);
    }
  return areas;
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
