#include "render/surface.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "core/base/error.h"
#include "render/gl/gl_scope.h"

namespace swaplight {

void clearSurface(int width, int height, Rgb code) {
  glViewport(0, 0, width, height);
  glClearColor(code.r, code.g, code.b, 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

void copyToSurface(const SurfaceCopy& copy) {
  const GlFramebuffer source = GlFramebuffer::make();
  const bool scissors = glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE;
  GLint read = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, source.id());
  glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, copy.texture, 0);
  glDisable(GL_SCISSOR_TEST);
  const int top = copy.surfaceHeight - copy.y;
  glBlitFramebuffer(0, 0, copy.width, copy.height, copy.x, top, copy.x + copy.width, top - copy.height,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  if (scissors) glEnable(GL_SCISSOR_TEST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read));
}

void finishDrawing() {
  glFinish();
}

std::vector<uint8_t> readSurface(int width, int height) {
  const size_t rowBytes = static_cast<size_t>(width) * 4;
  std::vector<uint8_t> upward(rowBytes * static_cast<size_t>(height));
  const TightPixels tight;
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upward.data());
  std::vector<uint8_t> rows(upward.size());
  for (int y = 0; y < height; ++y)
    std::copy_n(upward.data() + rowBytes * static_cast<size_t>(height - 1 - y), rowBytes,
                rows.data() + rowBytes * static_cast<size_t>(y));
  return rows;
}

SurfaceTarget::SurfaceTarget(int width, int height)
    : m_color(GlTexture::make()), m_framebuffer(GlFramebuffer::make()) {
  const BoundTexture texture(0, GL_TEXTURE_2D, m_color.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  const BoundFramebuffer target(m_framebuffer.id(), width, height);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_color.id(), 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw ResourceError("OpenGL cannot make a surface of this size to draw on. Choose a smaller size.");
}

void SurfaceTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
}

void SurfaceTexture::update(int width, int height, const uint8_t* rgba) {
  if (!m_texture) m_texture = GlTexture::make();
  const BoundTexture bound(0, GL_TEXTURE_2D, m_texture.id());
  const TightPixels tight;
  if (width != m_width || height != m_height) allocate(width, height);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
}

void SurfaceTexture::updatePart(int x, int y, int width, int height, const uint8_t* rgba) {
  const BoundTexture bound(0, GL_TEXTURE_2D, m_texture.id());
  const TightPixels tight;
  glPixelStorei(GL_UNPACK_ROW_LENGTH, m_width);
  glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, width, height, GL_RGBA, GL_UNSIGNED_BYTE,
                  rgba + 4 * (static_cast<ptrdiff_t>(y) * m_width + x));
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void SurfaceTexture::allocate(int width, int height) {
  // In the order in which a window keeps its bytes: software renderers copy that faster.
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_BGRA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  m_width = width;
  m_height = height;
}

}  // namespace swaplight
