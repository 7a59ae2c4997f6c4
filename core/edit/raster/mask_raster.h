#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/image/pixel_rect.h"

namespace swaplight {

constexpr int kMaskTile = 64;  ///< pixels: what a stroke changes, and so what undo keeps, is little

/// A mask as pixels, 0..1 in 16 bits, in tiles of 64 x 64; a tile that is all 0 takes no memory. Copies
/// share their tiles until one of them writes: keeping old states for undo costs what changed.
class MaskRaster {
 public:
  MaskRaster() = default;
  MaskRaster(int width, int height);

  [[nodiscard]] int width() const { return m_width; }
  [[nodiscard]] int height() const { return m_height; }
  [[nodiscard]] float at(int x, int y) const;
  /// Multiplies factors[0..count) by the pixels x.. of row y.
  void multiplyRow(int x, int y, int count, float* factors) const;

  /// The tile's pixels, row after row, to be written; makes the tile this raster's own first.
  [[nodiscard]] uint16_t* writableTile(int column, int row);
  [[nodiscard]] int columns() const { return (m_width + kMaskTile - 1) / kMaskTile; }
  [[nodiscard]] int rows() const { return (m_height + kMaskTile - 1) / kMaskTile; }
  /// Sets the pixels x.. of row y, in any tile; those outside of the raster are left out.
  void writeRow(int x, int y, int count, const float* values);
  /// Sets a pixel; slow, for shapes that are drawn once.
  void set(int x, int y, float value);

  /// Where pixels may be above 0, to the tile.
  [[nodiscard]] PixelRect bounds() const;
  /// The tiles in which pixels may be above 0.
  [[nodiscard]] std::vector<PixelRect> filledTiles() const;
  /// Whether pixels of the area may be above 0.
  [[nodiscard]] bool touches(const PixelRect& area) const;
  /// Where this and the other differ: a rectangle a tile, to the pixel; quick where tiles are shared.
  [[nodiscard]] std::vector<PixelRect> differences(const MaskRaster& other) const;
  [[nodiscard]] size_t bytes() const;
  /// The same without the tiles that are shared with another.
  [[nodiscard]] size_t bytesBeyond(const MaskRaster& other) const;

 private:
  using Tile = std::array<uint16_t, size_t{kMaskTile} * kMaskTile>;
  [[nodiscard]] PixelRect tileRect(int column, int row) const;
  [[nodiscard]] size_t tileIndex(int column, int row) const {
    return size_t(row) * size_t(columns()) + size_t(column);
  }

  int m_width = 0;
  int m_height = 0;
  std::vector<std::shared_ptr<Tile>> m_tiles;
};

}  // namespace swaplight
