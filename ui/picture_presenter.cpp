#include "ui/picture_presenter.h"

namespace swaplight {

unsigned PicturePresenter::texture(const Request& request) {
  if (m_shown == request) return m_texture.id();
  if (!m_table || !m_shown || m_shown->settings != request.settings ||
      m_shown->colorSpace != request.colorSpace)
    m_table.emplace(ColorConfig::current(), request.colorSpace, request.settings);
  if (!m_shown || m_shown->setRevision != request.setRevision) m_sum.forget();
  const std::vector<ViewLayer> layers =
      request.pictures->layers(request.subject, request.factors, request.ambientFactor);
  m_pixels.resize(static_cast<size_t>(request.window.width) * static_cast<size_t>(request.window.height) * 4);
  windowPixels(
      layers, request.window,
      [&](const float* r, const float* g, const float* b, int count, uint8_t* rgba) {
        m_table->apply(r, g, b, count, rgba);
      },
      m_pixels.data(), &m_sum);
  m_texture.update(request.window.width, request.window.height, m_pixels.data());
  m_shown = request;
  return m_texture.id();
}

}  // namespace swaplight
