#include "render/gl/shader_program.h"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <stdexcept>
#include <vector>

#include "render/gl/shader_source.h"

namespace swaplight {
namespace {

template <typename GetLength, typename GetLog>
std::string infoLog(GetLength getLength, GetLog getLog, GLuint id) {
  GLint length = 0;
  getLength(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<size_t>(length > 0 ? length : 0), '\0');
  if (length > 0) getLog(id, length, nullptr, log.data());
  while (!log.empty() && (log.back() == '\0' || log.back() == '\n')) log.pop_back();
  return log;
}

std::string withInjected(std::string source, const std::string& injected) {
  constexpr std::string_view kMark = "#pragma injected";
  const size_t at = source.find(kMark);
  if (at != std::string::npos) source.replace(at, kMark.size(), injected);
  return source;
}

struct SetUniform {
  int location;
  void operator()(int v) const { glUniform1i(location, v); }
  void operator()(float v) const { glUniform1f(location, v); }
  void operator()(const glm::ivec2& v) const { glUniform2i(location, v.x, v.y); }
  void operator()(const glm::vec2& v) const { glUniform2f(location, v.x, v.y); }
  void operator()(const glm::vec3& v) const { glUniform3f(location, v.x, v.y, v.z); }
  void operator()(const glm::vec4& v) const { glUniform4f(location, v.x, v.y, v.z, v.w); }
  void operator()(const glm::mat2& v) const { glUniformMatrix2fv(location, 1, GL_FALSE, &v[0][0]); }
  void operator()(const glm::mat3& v) const { glUniformMatrix3fv(location, 1, GL_FALSE, &v[0][0]); }
  void operator()(const glm::mat4& v) const { glUniformMatrix4fv(location, 1, GL_FALSE, &v[0][0]); }
  void operator()(std::span<const int> v) const {
    glUniform1iv(location, static_cast<GLsizei>(v.size()), v.data());
  }
  void operator()(std::span<const float> v) const {
    glUniform1fv(location, static_cast<GLsizei>(v.size()), v.data());
  }
  void operator()(std::span<const glm::vec3> v) const {
    if (!v.empty()) glUniform3fv(location, static_cast<GLsizei>(v.size()), &v[0].x);
  }
};

}  // namespace

ShaderProgram::ShaderProgram(const std::string& vertexFile, const std::string& fragmentFile,
                             const std::string& injected) {
  link({vertexFile, shaderSource(vertexFile)},
       {fragmentFile, withInjected(shaderSource(fragmentFile), injected)});
}

ShaderProgram ShaderProgram::fromSources(const std::string& vertex, const std::string& fragment) {
  ShaderProgram program;
  program.link({"", vertex}, {"", fragment});
  return program;
}

void ShaderProgram::compile(GLuint shader, const Source& source) {
  const char* text = source.text.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint ok = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok) return;
  const std::string words = infoLog(glGetShaderiv, glGetShaderInfoLog, shader);
  if (source.file.empty()) throw std::runtime_error(words);
  throw std::runtime_error(fmt::format("the shader {} does not compile:\n{}\n{}", source.file, words,
                                       numberedSource(source.text)));
}

void ShaderProgram::link(const Source& vertexSource, const Source& fragmentSource) {
  m_program = GlProgram::make();
  const auto vertex = GlVertexShader::make();
  const auto fragment = GlFragmentShader::make();
  compile(vertex.id(), vertexSource);
  compile(fragment.id(), fragmentSource);
  glAttachShader(id(), vertex.id());
  glAttachShader(id(), fragment.id());
  glLinkProgram(id());
  glDetachShader(id(), vertex.id());
  glDetachShader(id(), fragment.id());
  GLint ok = GL_FALSE;
  glGetProgramiv(id(), GL_LINK_STATUS, &ok);
  if (!ok) {
    const std::string words = infoLog(glGetProgramiv, glGetProgramInfoLog, id());
    if (fragmentSource.file.empty()) throw std::runtime_error(words);
    throw std::runtime_error(
        fmt::format("the shaders {} and {} do not link:\n{}", vertexSource.file, fragmentSource.file, words));
  }

  GLint count = 0, longest = 0;
  glGetProgramiv(id(), GL_ACTIVE_UNIFORMS, &count);
  glGetProgramiv(id(), GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
  std::vector<char> name(static_cast<size_t>(longest) + 1);
  for (GLint i = 0; i < count; ++i) {
    GLint size = 0;
    GLenum type = 0;
    glGetActiveUniform(id(), static_cast<GLuint>(i), longest, nullptr, &size, &type, name.data());
    const int location = glGetUniformLocation(id(), name.data());
    const std::string full = name.data();
    m_locations.emplace(full.substr(0, full.find("[0]")), location);
  }
}

void ShaderProgram::set(std::initializer_list<Uniform> uniforms) const {
  for (const Uniform& uniform : uniforms) {
    const auto found = m_locations.find(uniform.name);
    if (found == m_locations.end()) {
      std::string known;
      for (const auto& [name, location] : m_locations) known += (known.empty() ? "" : ", ") + name;
      throw std::logic_error(fmt::format("the shader has no uniform \"{}\"; it has {}", uniform.name, known));
    }
    std::visit(SetUniform{found->second}, uniform.value);
  }
}

}  // namespace swaplight
