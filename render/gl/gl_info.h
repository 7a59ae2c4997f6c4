#pragma once

#include <string>

namespace swaplight {

/// What the current context says of itself.
struct GlInfo {
  std::string vendor;
  std::string renderer;
  std::string version;
  int maxTextureSize = 0;  ///< pixels, of one side
  bool software = false;   ///< the processor draws: relight there, without the detour
};
[[nodiscard]] GlInfo glInfo();

/// True for the names (GL_RENDERER) of rasterisers that run on the processor.
[[nodiscard]] bool isSoftwareRenderer(const std::string& renderer);

/// Prints what the driver complains of to standard error and counts its errors. Does nothing in release
/// builds, and where the context has no KHR_debug.
void installGlDebugOutput();
[[nodiscard]] int glDebugErrorCount();

/// Throws ResourceError where the last calls ran out of graphics memory (`what` says for what), and
/// std::logic_error on any other OpenGL error.
void checkGl(const std::string& what);

/// Waits until everything asked for has been drawn. For measuring.
void finishGl();

}  // namespace swaplight
