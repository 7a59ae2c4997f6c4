#include "render/view_target.h"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include "render/gl/gl_info.h"
#include "render/gl/gl_scope.h"

namespace swaplight {

void ViewTarget::resize(int width, int height) {
  if (m_texture && width == m_width && height == m_height) return;
  m_width = width;
  m_height = height;
  m_texture = GlTexture::make();
  m_framebuffer = GlFramebuffer::make();
  const BoundTexture bound(0, GL_TEXTURE_2D, m_texture.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  const BoundFramebuffer target(m_framebuffer.id(), width, height);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_texture.id(), 0);
  checkGl(fmt::format("for a viewer of {} x {}", width, height));
}

std::vector<uint8_t> ViewTarget::readback() const {
  std::vector<uint8_t> pixels(static_cast<size_t>(m_width) * static_cast<size_t>(m_height) * 4);
  const TightPixels tight;
  const BoundFramebuffer source(m_framebuffer.id(), m_width, m_height);
  glReadPixels(0, 0, m_width, m_height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

}  // namespace swaplight
