#pragma once

#include "render/gl/gl_context.h"

namespace swaplight {

/// An OpenGL 4.1 core context without a window, display server or surface: draw into framebuffer objects.
/// Current on the thread that made it, until it is destroyed.
class EglContext : public GlContext {
 public:
  /// Throws ResourceError that says what EGL lacks here.
  EglContext();
  ~EglContext() override;

 private:
  void* m_display = nullptr;
  void* m_context = nullptr;
};

}  // namespace swaplight
