#pragma once

#include <cstdint>
#include <vector>

#include "core/color/rgb.h"
#include "render/gl/gl_handle.h"

namespace swaplight {

// What a user interface needs of OpenGL beside pictures: the surface that it draws on.

/// Fills what is bound for drawing with display code values 0..1, and makes all of it the viewport.
void clearSurface(int width, int height, Rgb code);

/// Waits until everything that was asked of OpenGL is done: for measuring.
void finishDrawing();

/// A texture that goes to a place of the surface pixel by pixel.
struct SurfaceCopy {
  unsigned texture = 0;  ///< row 0 at the top
  int width = 0, height = 0;
  int x = 0, y = 0;  ///< of its upper left corner, from the surface's upper left
  int surfaceHeight = 0;
};
/// Copies to what is bound for drawing, whatever the scissors. Where the surface keeps its rows from the top,
/// as windows do, this is a copy of memory for a software renderer, many times faster than drawing.
void copyToSurface(const SurfaceCopy& copy);

/// What has been drawn: 8-bit R G B A, row after row from the top, without gaps.
[[nodiscard]] std::vector<uint8_t> readSurface(int width, int height);

/// A surface in memory for where there is no window: 8-bit R G B A.
class SurfaceTarget {
 public:
  SurfaceTarget(int width, int height);
  /// Everything is drawn into it, and read from it, until something else is bound.
  void bind() const;

 private:
  GlTexture m_color;
  GlFramebuffer m_framebuffer;
};

/// A picture of 8-bit R G B A that changes often. Sampled without smoothing: it is made at the size at which
/// it is shown.
class SurfaceTexture {
 public:
  /// Rows from the top, without gaps.
  void update(int width, int height, const uint8_t* rgba);
  /// Only a part of it has changed; `rgba` is the whole picture, of the size that it had.
  void updatePart(int x, int y, int width, int height, const uint8_t* rgba);
  /// The texture's name; 0 before the first update.
  [[nodiscard]] unsigned id() const { return m_texture.id(); }

 private:
  void allocate(int width, int height);

  GlTexture m_texture;
  int m_width = 0;
  int m_height = 0;
};

}  // namespace swaplight
