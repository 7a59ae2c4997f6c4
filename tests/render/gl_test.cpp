#include "tests/render/gl_test.h"

#include <epoxy/gl.h>

#include "render/gl/gl_scope.h"

namespace swaplight {

GlStateSnapshot::GlStateSnapshot() {
  for (const GLenum name :
       {GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING, GL_ACTIVE_TEXTURE, GL_TEXTURE_BINDING_2D,
        GL_TEXTURE_BINDING_2D_ARRAY, GL_TEXTURE_BINDING_3D, GL_CURRENT_PROGRAM, GL_VERTEX_ARRAY_BINDING,
        GL_BLEND, GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_EQUATION_RGB, GL_SCISSOR_TEST, GL_DEPTH_TEST,
        GL_CULL_FACE, GL_FRAMEBUFFER_SRGB, GL_UNPACK_ALIGNMENT, GL_PACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH}) {
    int value = 0;
    glGetIntegerv(name, &value);
    values.push_back(value);
  }
  for (const GLenum name : {GL_VIEWPORT, GL_COLOR_WRITEMASK}) {
    int four[4]{};
    glGetIntegerv(name, four);
    values.insert(values.end(), four, four + 4);
  }
}

std::vector<uint8_t> texturePixels(unsigned texture, int width, int height) {
  const GlFramebuffer framebuffer = GlFramebuffer::make();
  const BoundFramebuffer bound(framebuffer.id(), width, height);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  std::vector<uint8_t> pixels(static_cast<size_t>(width) * static_cast<size_t>(height) * 4);
  const TightPixels tight;
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

}  // namespace swaplight
