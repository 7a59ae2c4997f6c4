#pragma once

#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "render/gl/gl_handle.h"

namespace swaplight {

using UniformValue =
    std::variant<int, float, glm::ivec2, glm::vec2, glm::vec3, glm::vec4, glm::mat2, glm::mat3, glm::mat4,
                 std::span<const int>, std::span<const float>, std::span<const glm::vec3>>;

struct Uniform {
  std::string_view name;
  UniformValue value;
};

/// A vertex and a fragment shader out of shaders/, linked.
class ShaderProgram {
 public:
  ShaderProgram() = default;
  /// `injected` is put where the fragment shader says `#pragma injected` (a view's code, written by OCIO).
  /// Throws std::runtime_error with the compiler's words and the numbered source.
  ShaderProgram(const std::string& vertexFile, const std::string& fragmentFile,
                const std::string& injected = "");
  /// Out of sources. Throws std::runtime_error with the compiler's words alone.
  [[nodiscard]] static ShaderProgram fromSources(const std::string& vertex, const std::string& fragment);

  [[nodiscard]] unsigned id() const { return m_program.id(); }
  explicit operator bool() const { return static_cast<bool>(m_program); }

  /// Sets uniforms of this program, which must be in use. Arrays go by their name without brackets. Throws
  /// std::logic_error that names an unknown uniform and lists the known.
  void set(std::initializer_list<Uniform> uniforms) const;
  [[nodiscard]] bool hasUniform(std::string_view name) const { return m_locations.contains(name); }

 private:
  struct Source {
    std::string file;  ///< named in errors, which show the text then; empty: no file of ours
    std::string text;
  };
  static void compile(unsigned shader, const Source& source);
  void link(const Source& vertex, const Source& fragment);

  GlProgram m_program;
  std::map<std::string, int, std::less<>> m_locations;
};

}  // namespace swaplight
