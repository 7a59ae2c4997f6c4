#pragma once

#include <cstdint>
#include <vector>

#include "render/gl/gl_handle.h"

namespace swaplight {

/// What a viewer draws into: 8-bit R G B A of its size, row 0 at the top.
class ViewTarget {
 public:
  /// Keeps what is there where the size stays. Throws ResourceError where there is no memory left.
  void resize(int width, int height);

  [[nodiscard]] unsigned texture() const { return m_texture.id(); }
  [[nodiscard]] unsigned framebuffer() const { return m_framebuffer.id(); }
  [[nodiscard]] int width() const { return m_width; }
  [[nodiscard]] int height() const { return m_height; }

  /// The pixels, from the top, without gaps.
  [[nodiscard]] std::vector<uint8_t> readback() const;

 private:
  GlTexture m_texture;
  GlFramebuffer m_framebuffer;
  int m_width = 0;
  int m_height = 0;
};

}  // namespace swaplight
