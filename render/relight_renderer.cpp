#include "render/relight_renderer.h"

#include <fmt/core.h>

#include <stdexcept>

#include "core/base/error.h"
#include "render/gl/gl_info.h"
#include "render/gl/pixel_transfer.h"

namespace swaplight {
namespace {

void checkMemory(const SolvedSet& set, size_t limit) {
  const size_t pictures = set.contributions.size() + (set.ambient ? 1 : 0) + 1;
  const size_t needed = TiledTexture::bytes(set.width(), set.height()) * pictures;
  if (limit == 0 || needed <= limit) return;
  constexpr double kMega = 1024.0 * 1024.0;
  throw ResourceError(
      fmt::format("{} lights at {} x {} need {:.0f} MB of graphics memory, the limit is {:.0f} MB. Use a "
                  "smaller picture, or "
                  "relight on the processor",
                  set.lightCount(), set.width(), set.height(), static_cast<double>(needed) / kMega,
                  static_cast<double>(limit) / kMega));
}

}  // namespace

RelightRenderer::RelightRenderer(const SolvedSet& set, const RelightRendererOptions& options)
    : m_lightCount(set.lightCount()), m_layers(options.lightsPerPass) {
  checkMemory(set, options.memoryLimit);
  const int side = largestTextureSide(options.maxTextureSide);
  const auto upload = [&](const Image& image) {
    m_pictures.emplace_back(set.width(), set.height(), side);
    updatePicture(m_pictures.back(), image.view(), 0, 0);
  };
  for (const Image& contribution : set.contributions) upload(contribution);
  if (set.ambient) upload(*set.ambient);
  m_frame = TiledTexture(set.width(), set.height(), side);
}

void RelightRenderer::updateContribution(int light, ImageView pixels, int x, int y) {
  if (light < 0 || light >= m_lightCount)
    throw std::logic_error(fmt::format("light {} of {} cannot be updated", light, m_lightCount));
  updatePicture(m_pictures[static_cast<size_t>(light)], pixels, x, y);
}

void RelightRenderer::updateAmbient(ImageView pixels, int x, int y) {
  if (static_cast<int>(m_pictures.size()) == m_lightCount)
    throw std::logic_error("this set has no ambient light to update");
  updatePicture(m_pictures.back(), pixels, x, y);
}

TiledTexture& RelightRenderer::relight(std::span<const Rgb> factors, float ambientFactor) {
  if (static_cast<int>(factors.size()) != m_lightCount)
    throw std::logic_error(fmt::format("{} factors for {} lights", factors.size(), m_lightCount));
  std::vector<TextureLayer> layers;
  for (size_t i = 0; i < m_pictures.size(); ++i)
    layers.push_back({&m_pictures[i], i < factors.size() ? factors[i] : Rgb(ambientFactor)});
  m_layers.draw(layers, m_frame);
  return m_frame;
}

Image RelightRenderer::readback() const {
  Image image(ImageSpec::rgb(width(), height()));
  readPicture(m_frame, image.span());
  return image;
}

}  // namespace swaplight
