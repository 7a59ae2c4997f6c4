#include "render/pixel_transfer.h"

#include <epoxy/gl.h>

#include "core/image/half.h"
#include "core/parallel.h"
#include "render/gl_info.h"
#include "render/gl_scope.h"

namespace swaplight {
namespace {

constexpr int kRowsPerBand = 32;

}  // namespace

std::vector<uint16_t> halfRgbaFromPlanes(ImageView rgb) {
  const auto width = static_cast<size_t>(rgb.width);
  std::vector<uint16_t> pixels(width * static_cast<size_t>(rgb.height) * 4);
  parallelRows(rgb.height, kRowsPerBand, [&](int begin, int end) {
    std::vector<uint16_t> row(width * 3);
    for (int y = begin; y < end; ++y) {
      for (int c = 0; c < 3; ++c) halfFromFloat(rgb.row(c, y), &row[width * static_cast<size_t>(c)], width);
      uint16_t* out = &pixels[static_cast<size_t>(y) * width * 4];
      for (size_t x = 0; x < width; ++x) {
        out[4 * x] = row[x];
        out[4 * x + 1] = row[width + x];
        out[4 * x + 2] = row[2 * width + x];
        out[4 * x + 3] = 0x3c00;  // 1
      }
    }
  });
  return pixels;
}

void readTiles(const TiledTexture& picture, ImageSpan out) {
  const TightPixels tight;
  for (const TiledTexture::Tile& tile : picture.tiles) {
    const auto width = static_cast<size_t>(tile.rect.width);
    std::vector<uint16_t> pixels(width * static_cast<size_t>(tile.rect.height) * 4);
    const BoundFramebuffer source(tile.framebuffer.id(), tile.rect.width, tile.rect.height);
    glReadPixels(0, 0, tile.rect.width, tile.rect.height, GL_RGBA, GL_HALF_FLOAT, pixels.data());
    const ImageSpan target = out.crop(tile.rect.x, tile.rect.y, tile.rect.width, tile.rect.height);
    parallelRows(target.height, kRowsPerBand, [&](int begin, int end) {
      std::vector<float> row(width * 4);
      for (int y = begin; y < end; ++y) {
        floatFromHalf(&pixels[static_cast<size_t>(y) * width * 4], row.data(), row.size());
        for (int c = 0; c < 3; ++c) {
          float* plane = target.row(c, y);
          for (size_t x = 0; x < width; ++x) plane[x] = row[4 * x + static_cast<size_t>(c)];
        }
      }
    });
  }
  checkGl("while reading a picture back");
}

void uploadTiles(TiledTexture& picture, ImageView rgb) {
  const TightPixels tight;
  for (const TiledTexture::Tile& tile : picture.tiles) {
    const TileRect& rect = tile.rect;
    const std::vector<uint16_t> pixels =
        halfRgbaFromPlanes(rgb.crop(rect.x, rect.y, rect.width, rect.height));
    const BoundTexture bound(0, GL_TEXTURE_2D, tile.texture.id());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, rect.width, rect.height, GL_RGBA, GL_HALF_FLOAT, pixels.data());
  }
  picture.halved = false;
  checkGl("while uploading a picture");
}

}  // namespace swaplight
