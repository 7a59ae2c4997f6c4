#include "render/gl/tiled_texture.h"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <algorithm>

#include "render/gl/gl_info.h"
#include "render/gl/gl_scope.h"

namespace swaplight {

std::vector<TileRect> tilesOf(int width, int height, int maxSide) {
  constexpr int kStep = 256;
  const int whole = std::max(maxSide, 1);
  const int side = whole >= kStep ? whole / kStep * kStep : whole;
  const int stepX = width <= whole ? width : side;
  const int stepY = height <= whole ? height : side;
  std::vector<TileRect> tiles;
  for (int y = 0; y < height; y += stepY)
    for (int x = 0; x < width; x += stepX)
      tiles.push_back({x, y, std::min(stepX, width - x), std::min(stepY, height - y)});
  return tiles;
}

int largestTextureSide(int limit) {
  // Drivers refuse single textures of several gigabytes, though they would take the same in parts.
  constexpr int kSensible = 8192;
  const int side = std::min(glInfo().maxTextureSize, kSensible);
  return limit > 0 ? std::min(limit, side) : side;
}

TiledTexture::TiledTexture(int pictureWidth, int pictureHeight, int maxSide)
    : width(pictureWidth), height(pictureHeight) {
  for (const TileRect& rect : tilesOf(width, height, maxSide)) {
    Tile tile{rect, GlTexture::make(), GlFramebuffer::make()};
    const BoundTexture texture(0, GL_TEXTURE_2D, tile.texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, rect.width, rect.height, 0, GL_RGBA, GL_HALF_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    checkGl(fmt::format("for a picture of {} x {}. Use a smaller one, or relight on the processor", width,
                        height));
    const BoundFramebuffer bound(tile.framebuffer.id(), rect.width, rect.height);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, tile.texture.id(), 0);
    checkGl("while a picture is made ready to draw into");
    tiles.push_back(std::move(tile));
  }
}

}  // namespace swaplight
