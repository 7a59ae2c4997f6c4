#include "render/gl/gl_info.h"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cstdio>
#include <stdexcept>

#include "core/base/error.h"

namespace swaplight {
namespace {

std::atomic<int>& debugErrors() {
  static std::atomic<int> count{0};
  return count;
}

std::string text(GLenum name) {
  const GLubyte* words = glGetString(name);
  return words ? reinterpret_cast<const char*>(words) : "unknown";
}

#ifndef NDEBUG
void APIENTRY onDebugMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* message,
                             const void*) {
  if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
  if (type == GL_DEBUG_TYPE_ERROR) ++debugErrors();
  fmt::print(stderr, "OpenGL: {}\n", message);
}
#endif

}  // namespace

GlInfo glInfo() {
  GlInfo info{text(GL_VENDOR), text(GL_RENDERER), text(GL_VERSION)};
  GLint rectangle = 0;  // of the targets of filters
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &info.maxTextureSize);
  glGetIntegerv(GL_MAX_RECTANGLE_TEXTURE_SIZE, &rectangle);
  info.maxTextureSize = std::min(info.maxTextureSize, rectangle);
  info.software = isSoftwareRenderer(info.renderer);
  return info;
}

bool isSoftwareRenderer(const std::string& renderer) {
  std::string lower = renderer;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::array<const char*, 6> kNames{"llvmpipe", "softpipe", "swiftshader",
                                              "swr (",    "software", "gdi generic"};
  return std::any_of(kNames.begin(), kNames.end(),
                     [&](const char* name) { return lower.find(name) != std::string::npos; });
}

void installGlDebugOutput() {
#ifndef NDEBUG
  if (epoxy_gl_version() < 43 && !epoxy_has_gl_extension("GL_KHR_debug")) return;
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(onDebugMessage, nullptr);
#endif
}

void finishGl() {
  glFinish();
}

int glDebugErrorCount() {
  return debugErrors();
}

void checkGl(const std::string& what) {
  GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  // Several may be waiting; the first tells most, the rest must not be blamed on later calls.
  while (glGetError() != GL_NO_ERROR) {
  }
  if (error == GL_OUT_OF_MEMORY)
    throw ResourceError(fmt::format("the graphics card has no memory left {}", what));
  throw std::logic_error(fmt::format("OpenGL error 0x{:04x} {}", error, what));
}

}  // namespace swaplight
