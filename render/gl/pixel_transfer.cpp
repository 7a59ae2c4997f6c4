#include "render/gl/pixel_transfer.h"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "core/base/parallel.h"
#include "core/image/half.h"
#include "render/gl/gl_info.h"
#include "render/gl/gl_scope.h"

namespace swaplight {
namespace {

constexpr int kRowsPerBand = 32;
constexpr int kPixelsPerUpload = 1 << 20;  // so that the interleaved copy stays small

/// Planes as interleaved half floats R G B 1. Light that half cannot hold becomes the brightest that it can:
/// as an infinity it would be NaN under a light that is off (0 times infinity).
void interleave(ImageView planes, std::vector<uint16_t>& pixels) {
  const auto width = static_cast<size_t>(planes.width);
  pixels.resize(width * static_cast<size_t>(planes.height) * 4);
  parallelRows(planes.height, kRowsPerBand, [&](int begin, int end) {
    std::vector<float> held(width);
    std::vector<uint16_t> row(width * 3);
    for (int y = begin; y < end; ++y) {
      for (int c = 0; c < 3; ++c) {
        const float* plane = planes.row(std::min(c, planes.channels - 1), y);
        std::transform(plane, plane + width, held.begin(), finiteClampedToHalf);
        halfFromFloat(held.data(), &row[width * static_cast<size_t>(c)], width);
      }
      uint16_t* out = &pixels[static_cast<size_t>(y) * width * 4];
      for (size_t x = 0; x < width; ++x) {
        out[4 * x] = row[x];
        out[4 * x + 1] = row[width + x];
        out[4 * x + 2] = row[2 * width + x];
        out[4 * x + 3] = 0x3c00;  // 1
      }
    }
  });
}

}  // namespace

void updatePicture(TiledTexture& picture, ImageView pixels, int x, int y) {
  if (x < 0 || y < 0 || x + pixels.width > picture.width || y + pixels.height > picture.height)
    throw std::logic_error(fmt::format("{} x {} pixels at {}, {} do not lie in a picture of {} x {}",
                                       pixels.width, pixels.height, x, y, picture.width, picture.height));
  const TightPixels tight;
  std::vector<uint16_t> band;
  for (const TiledTexture::Tile& tile : picture.tiles) {
    const TileRect& rect = tile.rect;
    const int left = std::max(x, rect.x), right = std::min(x + pixels.width, rect.x + rect.width);
    const int top = std::max(y, rect.y), bottom = std::min(y + pixels.height, rect.y + rect.height);
    if (left >= right || top >= bottom) continue;
    const BoundTexture bound(0, GL_TEXTURE_2D, tile.texture.id());
    const int bandRows = std::max(1, kPixelsPerUpload / (right - left));
    for (int row = top; row < bottom; row += bandRows) {
      const int rows = std::min(bandRows, bottom - row);
      interleave(pixels.crop(left - x, row - y, right - left, rows), band);
      glTexSubImage2D(GL_TEXTURE_2D, 0, left - rect.x, row - rect.y, right - left, rows, GL_RGBA,
                      GL_HALF_FLOAT, band.data());
    }
  }
  picture.halved = false;
  checkGl("while uploading a picture");
}

void readPicture(const TiledTexture& picture, ImageSpan out) {
  const TightPixels tight;
  std::vector<uint16_t> pixels;
  for (const TiledTexture::Tile& tile : picture.tiles) {
    const auto width = static_cast<size_t>(tile.rect.width);
    pixels.resize(width * static_cast<size_t>(tile.rect.height) * 4);
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

}  // namespace swaplight
