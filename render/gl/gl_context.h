#pragma once

#include <functional>
#include <memory>

namespace swaplight {

/// An OpenGL 4.1 core context, current on the thread that made it until it is destroyed there.
class GlContext {
 public:
  GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  virtual ~GlContext() = default;
};

/// Called on the thread that will draw. Throws ResourceError that says what OpenGL lacks here.
using GlContextSource = std::function<std::unique_ptr<GlContext>()>;

/// Where threads that draw beside a window get their contexts from; empty: from EGL, as a program without a
/// window does. The choice is the process's and not the window's, because libglvnd's is: once a driver's GLX
/// has been used it may have written its entry points into libGLdispatch, and the EGL of the same driver is
/// then refused (NVIDIA 580 with libglvnd 1.6: eglMakeCurrent fails).
void setGlContextSource(GlContextSource source);

/// A context for this thread, from there.
[[nodiscard]] std::unique_ptr<GlContext> newGlContext();

}  // namespace swaplight
