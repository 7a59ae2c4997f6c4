#include "render/gl/gl_handle.h"

#include <epoxy/gl.h>

#include <array>
#include <atomic>

namespace swaplight {
namespace {

std::atomic<int>& liveCount(GlKind kind) {
  static std::array<std::atomic<int>, kGlKinds> counts{};
  return counts[static_cast<size_t>(kind)];
}

}  // namespace

unsigned createGlObject(GlKind kind) {
  GLuint id = 0;
  switch (kind) {
    case GlKind::Buffer:
      glGenBuffers(1, &id);
      break;
    case GlKind::Framebuffer:
      glGenFramebuffers(1, &id);
      break;
    case GlKind::Program:
      id = glCreateProgram();
      break;
    case GlKind::VertexShader:
      id = glCreateShader(GL_VERTEX_SHADER);
      break;
    case GlKind::FragmentShader:
      id = glCreateShader(GL_FRAGMENT_SHADER);
      break;
    case GlKind::Texture:
      glGenTextures(1, &id);
      break;
    case GlKind::VertexArray:
      glGenVertexArrays(1, &id);
      break;
  }
  if (id != 0) ++liveCount(kind);
  return id;
}

void destroyGlObject(GlKind kind, unsigned id) {
  switch (kind) {
    case GlKind::Buffer:
      glDeleteBuffers(1, &id);
      break;
    case GlKind::Framebuffer:
      glDeleteFramebuffers(1, &id);
      break;
    case GlKind::Program:
      glDeleteProgram(id);
      break;
    case GlKind::VertexShader:
    case GlKind::FragmentShader:
      glDeleteShader(id);
      break;
    case GlKind::Texture:
      glDeleteTextures(1, &id);
      break;
    case GlKind::VertexArray:
      glDeleteVertexArrays(1, &id);
      break;
  }
  --liveCount(kind);
}

int liveGlObjects(GlKind kind) {
  return liveCount(kind);
}

int liveGlObjects() {
  int sum = 0;
  for (int kind = 0; kind < kGlKinds; ++kind) sum += liveCount(static_cast<GlKind>(kind));
  return sum;
}

}  // namespace swaplight
