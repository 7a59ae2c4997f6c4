#pragma once

#include "core/image/image.h"
#include "render/gl/gl_handle.h"

namespace swaplight {

/// A rectangle of a picture, counted from the left bottom corner, as OpenGL and ISF do.
struct FilterWindow {
  int x = 0, y = 0, width = 0, height = 0;
  int wholeWidth = 0, wholeHeight = 0;  ///< of the picture that it is a part of

  /// All of a picture.
  [[nodiscard]] static FilterWindow whole(int width, int height) {
    return {0, 0, width, height, width, height};
  }
  bool operator==(const FilterWindow&) const = default;
};

/// The rectangle's pixels on the graphics card, R G B A as 32-bit floats, the lowest row first; can be drawn
/// into and read with interpolation.
class FilterTexture {
 public:
  FilterTexture() = default;
  /// Not initialised. Throws ResourceError where graphics memory is short.
  explicit FilterTexture(const FilterWindow& window);

  [[nodiscard]] const FilterWindow& window() const { return m_window; }
  [[nodiscard]] unsigned texture() const { return m_texture.id(); }
  [[nodiscard]] unsigned framebuffer() const { return m_framebuffer.id(); }
  explicit operator bool() const { return static_cast<bool>(m_texture); }

  /// Black, without alpha.
  void clear() const;
  /// The window's part of a picture of planes R G B, or R G B A; without A it is 1. The top row comes first.
  /// What is not a number becomes 0, what is beyond +-kBrightest that.
  void upload(ImageView picture) const;
  /// Writes the part of the window that `rect` is (also counted from the left bottom) into a picture of 3 or
  /// 4 planes.
  void download(const FilterWindow& rect, ImageSpan picture) const;

  /// The brightest value that filters see and give.
  static constexpr float kBrightest = 1e10F;

 private:
  FilterWindow m_window;
  GlTexture m_texture;
  GlFramebuffer m_framebuffer;
};

}  // namespace swaplight
