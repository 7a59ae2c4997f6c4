#pragma once

#include <utility>

namespace swaplight {

enum class GlKind { Buffer, Framebuffer, Program, VertexShader, FragmentShader, Texture, VertexArray };
inline constexpr int kGlKinds = 7;

/// The bare calls behind GlHandle, in the current context.
[[nodiscard]] unsigned createGlObject(GlKind kind);
void destroyGlObject(GlKind kind, unsigned id);

/// How many handles of a kind, or of any kind, are alive in this process. For tests.
[[nodiscard]] int liveGlObjects(GlKind kind);
[[nodiscard]] int liveGlObjects();

/// Owns one OpenGL object; 0 owns nothing. Must be destroyed while its context is current.
template <GlKind kind>
class GlHandle {
 public:
  GlHandle() = default;
  [[nodiscard]] static GlHandle make() {
    GlHandle handle;
    handle.m_id = createGlObject(kind);
    return handle;
  }
  GlHandle(GlHandle&& other) noexcept : m_id(std::exchange(other.m_id, 0)) {}
  GlHandle& operator=(GlHandle&& other) noexcept {
    std::swap(m_id, other.m_id);
    return *this;
  }
  GlHandle(const GlHandle&) = delete;
  GlHandle& operator=(const GlHandle&) = delete;
  ~GlHandle() {
    if (m_id != 0) destroyGlObject(kind, m_id);
  }

  [[nodiscard]] unsigned id() const { return m_id; }
  explicit operator bool() const { return m_id != 0; }

 private:
  unsigned m_id = 0;
};

using GlBuffer = GlHandle<GlKind::Buffer>;
using GlFramebuffer = GlHandle<GlKind::Framebuffer>;
using GlProgram = GlHandle<GlKind::Program>;
using GlVertexShader = GlHandle<GlKind::VertexShader>;
using GlFragmentShader = GlHandle<GlKind::FragmentShader>;
using GlTexture = GlHandle<GlKind::Texture>;
using GlVertexArray = GlHandle<GlKind::VertexArray>;

}  // namespace swaplight
