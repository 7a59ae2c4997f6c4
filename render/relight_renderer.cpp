#include "render/relight_renderer.h"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "core/error.h"
#include "render/gl_info.h"
#include "render/gl_scope.h"
#include "render/pixel_transfer.h"

namespace swaplight {
namespace {

constexpr int kMaxLightsPerPass = 64;  // kMaxLights of relight.frag
constexpr size_t kBytesPerPixel = 8;   // RGBA16F: what graphics cards make of RGB16F anyway
// Drivers refuse single textures of several gigabytes, though they would take the same in parts.
constexpr size_t kMaxArrayBytes = size_t{1} << 30;

int tileSide(const SolvedSet& set, int layers, int maxSide) {
  int side = maxSide;
  const auto bytes = [&](int s) {
    return static_cast<size_t>(std::min(s, set.width())) * static_cast<size_t>(std::min(s, set.height())) *
           static_cast<size_t>(layers) * kBytesPerPixel;
  };
  while (side > 512 && bytes(side) > kMaxArrayBytes) side /= 2;
  return side;
}

void checkMemory(const SolvedSet& set, int layers, size_t limit) {
  const size_t needed = static_cast<size_t>(set.width()) * static_cast<size_t>(set.height()) *
                        static_cast<size_t>(layers + 1) * kBytesPerPixel;
  if (limit == 0 || needed <= limit) return;
  constexpr double kMega = 1024.0 * 1024.0;
  throw ResourceError(
      fmt::format("{} lights at {} x {} need {:.0f} MB of graphics memory, the limit is {:.0f} MB. Use a "
                  "smaller picture, "
                  "or relight on the processor",
                  set.lightCount(), set.width(), set.height(), static_cast<double>(needed) / kMega,
                  static_cast<double>(limit) / kMega));
}

}  // namespace

RelightRenderer::RelightRenderer(const SolvedSet& set, const RelightRendererOptions& options)
    : m_lightCount(set.lightCount()),
      m_hasAmbient(set.ambient.has_value()),
      m_lightsPerPass(std::clamp(options.lightsPerPass, 1, kMaxLightsPerPass)),
      m_program("fullscreen.vert", "relight.frag"),
      m_vertexArray(GlVertexArray::make()) {
  const GlInfo info = glInfo();
  const int layers = m_lightCount + (m_hasAmbient ? 1 : 0);
  if (layers > info.maxLayers)
    throw ResourceError(
        fmt::format("{} lights are more than the {} that this graphics card holds. Relight on the "
                    "processor",
                    layers, info.maxLayers));
  checkMemory(set, layers, options.memoryLimit);
  const int limit = options.maxTextureSide > 0 ? std::min(options.maxTextureSide, info.maxTextureSize)
                                               : info.maxTextureSize;
  m_frame = TiledTexture(set.width(), set.height(), tileSide(set, layers, limit));
  for (const TiledTexture::Tile& tile : m_frame.tiles) {
    GlTexture texture = GlTexture::make();
    const BoundTexture bound(0, GL_TEXTURE_2D_ARRAY, texture.id());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA16F, tile.rect.width, tile.rect.height, layers, 0, GL_RGBA,
                 GL_HALF_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    checkGl(fmt::format("for {} lights at {} x {}. Use a smaller picture, or relight on the processor",
                        m_lightCount, set.width(), set.height()));
    m_contributions.push_back(std::move(texture));
  }
  for (int i = 0; i < m_lightCount; ++i)
    updateContribution(i, set.contributions[static_cast<size_t>(i)].view(), 0, 0);
  if (m_hasAmbient) updateAmbient(set.ambient->view(), 0, 0);
}

void RelightRenderer::updateContribution(int light, ImageView pixels, int x, int y) {
  if (light < 0 || light >= m_lightCount)
    throw std::logic_error(fmt::format("light {} of {} cannot be updated", light, m_lightCount));
  updateLayer(light, pixels, x, y);
}

void RelightRenderer::updateLayer(int layer, ImageView pixels, int x, int y) {
  if (layer == m_lightCount && !m_hasAmbient)
    throw std::logic_error("this set has no ambient light to update");
  if (pixels.channels != 3 || x < 0 || y < 0 || x + pixels.width > width() || y + pixels.height > height())
    throw std::logic_error(
        fmt::format("{} x {} pixels with {} channels at {}, {} do not lie in a picture of {} x {}",
                    pixels.width, pixels.height, pixels.channels, x, y, width(), height()));
  const TightPixels tight;
  for (size_t t = 0; t < m_frame.tiles.size(); ++t) {
    const TileRect& tile = m_frame.tiles[t].rect;
    const int left = std::max(x, tile.x), right = std::min(x + pixels.width, tile.x + tile.width);
    const int top = std::max(y, tile.y), bottom = std::min(y + pixels.height, tile.y + tile.height);
    if (left >= right || top >= bottom) continue;
    const BoundTexture bound(0, GL_TEXTURE_2D_ARRAY, m_contributions[t].id());
    // In bands, so that the interleaved copy stays small.
    const int bandRows = std::max(1, (1 << 20) / (right - left));
    for (int row = top; row < bottom; row += bandRows) {
      const int rows = std::min(bandRows, bottom - row);
      const std::vector<uint16_t> band =
          halfRgbaFromPlanes(pixels.crop(left - x, row - y, right - left, rows));
      glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, left - tile.x, row - tile.y, layer, right - left, rows, 1,
                      GL_RGBA, GL_HALF_FLOAT, band.data());
    }
  }
}

TiledTexture& RelightRenderer::relight(std::span<const Rgb> factors, float ambientFactor) {
  if (static_cast<int>(factors.size()) != m_lightCount)
    throw std::logic_error(fmt::format("{} factors for {} lights", factors.size(), m_lightCount));
  // Lights that are off cost nothing.
  std::vector<int> layers;
  std::vector<glm::vec3> strengths;
  for (int i = 0; i < m_lightCount; ++i) {
    const Rgb& factor = factors[static_cast<size_t>(i)];
    if (factor == Rgb(0)) continue;
    layers.push_back(i);
    strengths.push_back(factor);
  }
  if (m_hasAmbient && ambientFactor != 0) {
    layers.push_back(m_lightCount);
    strengths.emplace_back(ambientFactor);
  }

  const OverwriteState overwrite;
  const BoundProgram program(m_program.id(), m_vertexArray.id());
  m_program.set({{"contributions", 0}});
  for (size_t t = 0; t < m_frame.tiles.size(); ++t) {
    const TiledTexture::Tile& tile = m_frame.tiles[t];
    const BoundFramebuffer target(tile.framebuffer.id(), tile.rect.width, tile.rect.height);
    const BoundTexture contributions(0, GL_TEXTURE_2D_ARRAY, m_contributions[t].id());
    const auto drawPass = [&](size_t first) {
      const size_t count = std::min(layers.size() - first, static_cast<size_t>(m_lightsPerPass));
      m_program.set({{"lightCount", static_cast<int>(count)},
                     {"layers", std::span<const int>(layers).subspan(first, count)},
                     {"factors", std::span<const glm::vec3>(strengths).subspan(first, count)}});
      glDrawArrays(GL_TRIANGLES, 0, 3);
      return first + count;
    };
    size_t done = drawPass(0);
    if (done == layers.size()) continue;
    const AdditiveBlending adding;
    while (done < layers.size()) done = drawPass(done);
  }
  m_frame.halved = false;
  checkGl("while relighting");
  return m_frame;
}

Image RelightRenderer::readback() const {
  Image image(ImageSpec::rgb(width(), height()));
  readTiles(m_frame, image.span());
  return image;
}

}  // namespace swaplight
