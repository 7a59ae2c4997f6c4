#pragma once

#include <cstddef>
#include <vector>

#include "render/gl/gl_handle.h"

namespace swaplight {

/// A picture cut into rectangles, because no texture is larger than the graphics card's limit.
struct TileRect {
  int x = 0, y = 0, width = 0, height = 0;  ///< pixels of the picture; row 0 is the top
};

/// Row after row. Sides are at most `maxSide` pixels, and multiples of 256 where there is more than one, so
/// that halved pictures meet without a seam.
[[nodiscard]] std::vector<TileRect> tilesOf(int width, int height, int maxSide);

/// A linear picture on the graphics card: RGBA16F, row 0 of a texture is its top row.
struct TiledTexture {
  struct Tile {
    TileRect rect;
    GlTexture texture;
    GlFramebuffer framebuffer;  ///< for drawing into the texture and reading it back
  };
  int width = 0;
  int height = 0;
  std::vector<Tile> tiles;
  bool halved = false;  ///< its halved pictures (mip levels) are those of the picture as it is now

  TiledTexture() = default;
  /// Not initialised. Throws ResourceError where the graphics card has no memory left.
  TiledTexture(int pictureWidth, int pictureHeight, int maxSide);

  /// The graphics memory that a picture takes.
  [[nodiscard]] static size_t bytes(int width, int height) {
    constexpr size_t kBytesPerPixel = 8;
    return static_cast<size_t>(width) * static_cast<size_t>(height) * kBytesPerPixel;
  }
};

/// The longest side of a texture here, or `limit` where that is shorter and not 0.
[[nodiscard]] int largestTextureSide(int limit = 0);

}  // namespace swaplight
