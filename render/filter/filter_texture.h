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
  /// With that many pixels more on every side, as far as the picture goes.
  [[nodiscard]] FilterWindow grown(int halo) const;
  [[nodiscard]] size_t pixelCount() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
  bool operator==(const FilterWindow&) const = default;
};

/// How a texture is read between its pixels. By their numbers it is the same to the bit whatever part of a
/// picture the texture holds; by coordinates from 0 to 1, which plain ISF filters know, it is rounded by the
/// texture's size.
enum class TextureKind { Coordinates, Pixels };

/// The rectangle's pixels on the graphics card, R G B A as 32-bit floats, the lowest row first; can be drawn
/// into and read with interpolation.
class FilterTexture {
 public:
  FilterTexture() = default;
  /// Not initialised. Throws ResourceError where graphics memory is short.
  explicit FilterTexture(const FilterWindow& window, TextureKind kind = TextureKind::Coordinates);

  [[nodiscard]] const FilterWindow& window() const { return m_window; }
  [[nodiscard]] TextureKind kind() const { return m_kind; }
  /// OpenGL's GL_TEXTURE_2D or GL_TEXTURE_RECTANGLE.
  [[nodiscard]] unsigned target() const;
  [[nodiscard]] unsigned texture() const { return m_texture.id(); }
  [[nodiscard]] unsigned framebuffer() const { return m_framebuffer.id(); }
  explicit operator bool() const { return static_cast<bool>(m_texture); }

  /// Black, without alpha.
  void clear() const;
  /// The window's part of a picture of planes R G B, or R G B A; without A it is 1. The top row comes first.
  /// What is not a number becomes 0, an infinite value the most of half float, what is beyond +-kBrightest
  /// that.
  void upload(ImageView picture) const;
  /// Writes the part of the window that `rect` is (also counted from the left bottom) into a picture of 3 or
  /// 4 planes.
  void download(const FilterWindow& rect, ImageSpan picture) const;

  static constexpr size_t kBytesPerPixel = 4 * sizeof(float);
  /// The brightest value that filters see and give.
  static constexpr float kBrightest = 1e10F;

 private:
  FilterWindow m_window;
  TextureKind m_kind = TextureKind::Coordinates;
  GlTexture m_texture;
  GlFramebuffer m_framebuffer;
};

}  // namespace swaplight
