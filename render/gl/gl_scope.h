#pragma once

#include <epoxy/gl.h>

#include <array>
#include <deque>

namespace swaplight {

// Scope guards: each sets a piece of OpenGL state and puts back what was there. So that drawing into a
// texture in the middle of somebody else's frame (the studio's) leaves no trace.

/// Binds a framebuffer for drawing and reading, with its viewport.
class BoundFramebuffer {
 public:
  BoundFramebuffer(GLuint id, int width, int height) {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_draw);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &m_read);
    glGetIntegerv(GL_VIEWPORT, m_viewport.data());
    glBindFramebuffer(GL_FRAMEBUFFER, id);
    glViewport(0, 0, width, height);
  }
  BoundFramebuffer(const BoundFramebuffer&) = delete;
  BoundFramebuffer& operator=(const BoundFramebuffer&) = delete;
  ~BoundFramebuffer() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(m_draw));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(m_read));
    glViewport(m_viewport[0], m_viewport[1], m_viewport[2], m_viewport[3]);
  }

 private:
  GLint m_draw = 0, m_read = 0;
  std::array<GLint, 4> m_viewport{};
};

/// Binds a texture (GL_TEXTURE_2D, _2D_ARRAY, _3D, _1D) to a unit.
class BoundTexture {
 public:
  BoundTexture(int unit, GLenum target, GLuint id)
      : m_unit(GL_TEXTURE0 + static_cast<GLenum>(unit)), m_target(target) {
    glGetIntegerv(GL_ACTIVE_TEXTURE, &m_active);
    glActiveTexture(m_unit);
    glGetIntegerv(bindingOf(target), &m_before);
    glBindTexture(target, id);
  }
  BoundTexture(const BoundTexture&) = delete;
  BoundTexture& operator=(const BoundTexture&) = delete;
  ~BoundTexture() {
    glActiveTexture(m_unit);
    glBindTexture(m_target, static_cast<GLuint>(m_before));
    glActiveTexture(static_cast<GLenum>(m_active));
  }

 private:
  static GLenum bindingOf(GLenum target) {
    switch (target) {
      case GL_TEXTURE_1D:
        return GL_TEXTURE_BINDING_1D;
      case GL_TEXTURE_2D_ARRAY:
        return GL_TEXTURE_BINDING_2D_ARRAY;
      case GL_TEXTURE_3D:
        return GL_TEXTURE_BINDING_3D;
      case GL_TEXTURE_RECTANGLE:
        return GL_TEXTURE_BINDING_RECTANGLE;
      default:
        return GL_TEXTURE_BINDING_2D;
    }
  }
  GLenum m_unit, m_target;
  GLint m_active = 0, m_before = 0;
};

/// Binds textures to the units 0, 1, 2 ...
class BoundTextures {
 public:
  BoundTextures() = default;
  BoundTextures(const BoundTextures&) = delete;
  BoundTextures& operator=(const BoundTextures&) = delete;
  ~BoundTextures() {
    while (!m_bound.empty()) m_bound.pop_back();  // the last first: each puts back what it found
  }
  /// Returns the unit.
  int add(GLenum target, GLuint id) {
    const int unit = static_cast<int>(m_bound.size());
    m_bound.emplace_back(unit, target, id);
    return unit;
  }

 private:
  std::deque<BoundTexture> m_bound;
};

/// Uses a program with a vertex array.
class BoundProgram {
 public:
  BoundProgram(GLuint program, GLuint vertexArray) {
    glGetIntegerv(GL_CURRENT_PROGRAM, &m_program);
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &m_vertexArray);
    glUseProgram(program);
    glBindVertexArray(vertexArray);
  }
  BoundProgram(const BoundProgram&) = delete;
  BoundProgram& operator=(const BoundProgram&) = delete;
  ~BoundProgram() {
    glUseProgram(static_cast<GLuint>(m_program));
    glBindVertexArray(static_cast<GLuint>(m_vertexArray));
  }

 private:
  GLint m_program = 0, m_vertexArray = 0;
};

/// Turns a capability (GL_BLEND, GL_SCISSOR_TEST ...) on or off.
class Capability {
 public:
  Capability(GLenum name, bool on) : m_name(name), m_before(glIsEnabled(name) == GL_TRUE) { set(on); }
  Capability(const Capability&) = delete;
  Capability& operator=(const Capability&) = delete;
  ~Capability() { set(m_before); }

 private:
  void set(bool on) const { on ? glEnable(m_name) : glDisable(m_name); }
  GLenum m_name;
  bool m_before;
};

/// Plain drawing of a triangle that overwrites every pixel: no blending, no tests, all channels written.
class OverwriteState {
 public:
  OverwriteState() {
    glGetBooleanv(GL_COLOR_WRITEMASK, m_mask.data());
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  OverwriteState(const OverwriteState&) = delete;
  OverwriteState& operator=(const OverwriteState&) = delete;
  ~OverwriteState() { glColorMask(m_mask[0], m_mask[1], m_mask[2], m_mask[3]); }

 private:
  Capability m_blend{GL_BLEND, false}, m_scissor{GL_SCISSOR_TEST, false}, m_depth{GL_DEPTH_TEST, false},
      m_stencil{GL_STENCIL_TEST, false}, m_cull{GL_CULL_FACE, false}, m_srgb{GL_FRAMEBUFFER_SRGB, false};
  std::array<GLboolean, 4> m_mask{};
};

/// Blending that adds what is drawn to what is there.
class AdditiveBlending {
 public:
  AdditiveBlending() {
    const std::array<GLenum, 6> names{GL_BLEND_SRC_RGB,   GL_BLEND_DST_RGB,      GL_BLEND_SRC_ALPHA,
                                      GL_BLEND_DST_ALPHA, GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};
    for (size_t i = 0; i < names.size(); ++i) glGetIntegerv(names[i], &m_before[i]);
    glBlendFunc(GL_ONE, GL_ONE);
    glBlendEquation(GL_FUNC_ADD);
  }
  AdditiveBlending(const AdditiveBlending&) = delete;
  AdditiveBlending& operator=(const AdditiveBlending&) = delete;
  ~AdditiveBlending() {
    const auto value = [&](size_t i) { return static_cast<GLenum>(m_before[i]); };
    glBlendFuncSeparate(value(0), value(1), value(2), value(3));
    glBlendEquationSeparate(value(4), value(5));
  }

 private:
  Capability m_blend{GL_BLEND, true};
  std::array<GLint, 6> m_before{};
};

/// Pixel transfer of rows without gaps or padding, from and to client memory.
class TightPixels {
 public:
  TightPixels() {
    for (size_t i = 0; i < kNames.size(); ++i) {
      glGetIntegerv(kNames[i], &m_before[i]);
      const bool alignment = kNames[i] == GL_UNPACK_ALIGNMENT || kNames[i] == GL_PACK_ALIGNMENT;
      glPixelStorei(kNames[i], alignment ? 1 : 0);
    }
    glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &m_unpack);
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &m_pack);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  }
  TightPixels(const TightPixels&) = delete;
  TightPixels& operator=(const TightPixels&) = delete;
  ~TightPixels() {
    for (size_t i = 0; i < kNames.size(); ++i) glPixelStorei(kNames[i], m_before[i]);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(m_unpack));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(m_pack));
  }

 private:
  static constexpr std::array<GLenum, 8> kNames{
      GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
      GL_PACK_ALIGNMENT,   GL_PACK_ROW_LENGTH,   GL_PACK_SKIP_ROWS,   GL_PACK_SKIP_PIXELS};
  std::array<GLint, 8> m_before{};
  GLint m_unpack = 0, m_pack = 0;
};

}  // namespace swaplight
