#include "render/filter/filter_texture.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/gl/gl_info.h"
#include "render/gl/gl_scope.h"

namespace swaplight {
namespace {

constexpr int kRowsAtOnce = 64;  // so that the interleaved copy stays small

constexpr float kMostOfHalf = 65504;

float sane(float value) {
  if (std::isnan(value)) return 0;
  // A highlight that half float could not hold; of the brightest that there is a glow would fill the frame.
  if (std::isinf(value)) return value > 0 ? kMostOfHalf : 0;
  return std::clamp(value, -FilterTexture::kBrightest, FilterTexture::kBrightest);
}

}  // namespace

FilterWindow FilterWindow::grown(int halo) const {
  FilterWindow window = *this;
  window.x = std::max(0, x - halo);
  window.y = std::max(0, y - halo);
  window.width = std::min(wholeWidth, x + width + halo) - window.x;
  window.height = std::min(wholeHeight, y + height + halo) - window.y;
  return window;
}

unsigned FilterTexture::target() const {
  return m_kind == TextureKind::Pixels ? GL_TEXTURE_RECTANGLE : GL_TEXTURE_2D;
}

FilterTexture::FilterTexture(const FilterWindow& window, TextureKind kind)
    : m_window(window), m_kind(kind), m_texture(GlTexture::make()), m_framebuffer(GlFramebuffer::make()) {
  const BoundTexture texture(0, target(), m_texture.id());
  glTexImage2D(target(), 0, GL_RGBA32F, window.width, window.height, 0, GL_RGBA, GL_FLOAT, nullptr);
  glTexParameteri(target(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(target(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(target(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(target(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  const BoundFramebuffer bound(m_framebuffer.id(), window.width, window.height);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target(), m_texture.id(), 0);
  checkGl(fmt::format("for a filter's {} x {} pixels", window.width, window.height));
}

void FilterTexture::clear() const {
  const OverwriteState overwrite;
  const BoundFramebuffer bound(framebuffer(), m_window.width, m_window.height);
  constexpr std::array<float, 4> kNothing{};
  glClearBufferfv(GL_COLOR, 0, kNothing.data());
}

void FilterTexture::upload(ImageView picture) const {
  const TightPixels tight;
  const BoundTexture bound(0, target(), texture());
  const auto width = static_cast<size_t>(m_window.width);
  std::vector<float> band;
  for (int first = 0; first < m_window.height; first += kRowsAtOnce) {
    const int rows = std::min(kRowsAtOnce, m_window.height - first);
    band.assign(width * static_cast<size_t>(rows) * 4, 1);
    for (int r = 0; r < rows; ++r) {
      const int y = m_window.wholeHeight - 1 - (m_window.y + first + r);
      for (int c = 0; c < std::min(picture.channels, 4); ++c) {
        const float* in = picture.row(c, y) + m_window.x;
        float* out = &band[static_cast<size_t>(r) * width * 4 + static_cast<size_t>(c)];
        for (size_t x = 0; x < width; ++x) out[4 * x] = sane(in[x]);
      }
    }
    glTexSubImage2D(target(), 0, 0, first, m_window.width, rows, GL_RGBA, GL_FLOAT, band.data());
  }
  checkGl("while a filter's picture is uploaded");
}

void FilterTexture::download(const FilterWindow& rect, ImageSpan picture) const {
  const TightPixels tight;
  const BoundFramebuffer source(framebuffer(), m_window.width, m_window.height);
  const auto width = static_cast<size_t>(rect.width);
  std::vector<float> band(width * kRowsAtOnce * 4);
  for (int first = 0; first < rect.height; first += kRowsAtOnce) {
    const int rows = std::min(kRowsAtOnce, rect.height - first);
    glReadPixels(rect.x - m_window.x, rect.y - m_window.y + first, rect.width, rows, GL_RGBA, GL_FLOAT,
                 band.data());
    for (int r = 0; r < rows; ++r) {
      const int y = m_window.wholeHeight - 1 - (rect.y + first + r);
      for (int c = 0; c < std::min(picture.channels, 4); ++c) {
        float* out = picture.row(c, y) + rect.x;
        const float* in = &band[static_cast<size_t>(r) * width * 4 + static_cast<size_t>(c)];
        for (size_t x = 0; x < width; ++x) out[x] = in[4 * x];
      }
    }
  }
  checkGl("while a filter's picture is read back");
}

}  // namespace swaplight
