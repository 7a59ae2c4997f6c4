#include "render/display_program.h"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <array>
#include <glm/vec3.hpp>

#include "core/base/error.h"
#include "core/ocio/color_config_impl.h"
#include "render/gl/gl_info.h"
#include "render/gl/gl_scope.h"

namespace swaplight {
namespace {

constexpr const char* kVertex = "fullscreen.vert";
constexpr const char* kFragment = "view.frag";

GlTexture makeTable(GLenum target, OCIO::Interpolation interpolation) {
  GlTexture texture = GlTexture::make();
  const BoundTexture bound(0, target, texture.id());
  const GLint filter = interpolation == OCIO::INTERP_NEAREST ? GL_NEAREST : GL_LINEAR;
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    if (target == GL_TEXTURE_3D || axis != GL_TEXTURE_WRAP_R) glTexParameteri(target, axis, GL_CLAMP_TO_EDGE);
  return texture;
}

std::vector<DisplayProgram::Table> cubesOf(const OCIO::GpuShaderDescRcPtr& shader) {
  std::vector<DisplayProgram::Table> tables;
  for (unsigned i = 0; i < shader->getNum3DTextures(); ++i) {
    const char* name = nullptr;
    const char* sampler = nullptr;
    unsigned side = 0;
    OCIO::Interpolation interpolation = OCIO::INTERP_LINEAR;
    shader->get3DTexture(i, name, sampler, side, interpolation);
    const float* values = nullptr;
    shader->get3DTextureValues(i, values);
    GlTexture texture = makeTable(GL_TEXTURE_3D, interpolation);
    const BoundTexture bound(0, GL_TEXTURE_3D, texture.id());
    const auto size = static_cast<GLsizei>(side);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB32F, size, size, size, 0, GL_RGB, GL_FLOAT, values);
    tables.push_back({sampler, GL_TEXTURE_3D, std::move(texture)});
  }
  return tables;
}

std::vector<DisplayProgram::Table> curvesOf(const OCIO::GpuShaderDescRcPtr& shader) {
  std::vector<DisplayProgram::Table> tables;
  for (unsigned i = 0; i < shader->getNumTextures(); ++i) {
    const char* name = nullptr;
    const char* sampler = nullptr;
    unsigned width = 0, height = 0;
    OCIO::GpuShaderDesc::TextureType channels = OCIO::GpuShaderDesc::TEXTURE_RGB_CHANNEL;
    OCIO::Interpolation interpolation = OCIO::INTERP_LINEAR;
    shader->getTexture(i, name, sampler, width, height, channels, interpolation);
    const float* values = nullptr;
    shader->getTextureValues(i, values);
    const bool red = channels == OCIO::GpuShaderDesc::TEXTURE_RED_CHANNEL;
    const GLint stored = red ? GL_R32F : GL_RGB32F;
    const GLenum given = red ? GL_RED : GL_RGB;
    const GLenum target = height > 1 ? GL_TEXTURE_2D : GL_TEXTURE_1D;
    GlTexture texture = makeTable(target, interpolation);
    const BoundTexture bound(0, target, texture.id());
    if (target == GL_TEXTURE_2D)
      glTexImage2D(target, 0, stored, static_cast<GLsizei>(width), static_cast<GLsizei>(height), 0, given,
                   GL_FLOAT, values);
    else
      glTexImage1D(target, 0, stored, static_cast<GLsizei>(width), 0, given, GL_FLOAT, values);
    tables.push_back({sampler, target, std::move(texture)});
  }
  return tables;
}

OCIO::GpuShaderDescRcPtr shaderOf(const OCIO::ConstGPUProcessorRcPtr& processor, const char* function,
                                  const char* prefix) {
  OCIO::GpuShaderDescRcPtr shader = OCIO::GpuShaderDesc::CreateShaderDesc();
  shader->setLanguage(OCIO::GPU_LANGUAGE_GLSL_4_0);
  shader->setFunctionName(function);
  shader->setResourcePrefix(prefix);
  processor->extractGpuShaderInfo(shader);
  return shader;
}

/// What core/ocio/grade_transform.cpp does, with the grade in uniforms: a slider needs no other program.
std::string gradeText(double highest) {
  return fmt::format(R"(
uniform vec3 gradeSlope;
uniform vec3 gradeOffset;
uniform vec3 gradePower;
uniform float gradeSaturation;
vec4 displayFromScene(vec4 light) {{
  vec4 code = gradingFromScene(light);
  vec3 v = code.rgb * gradeSlope + gradeOffset;
  v = min(mix(v, pow(max(v, 0.0), gradePower), greaterThan(v, vec3(0.0))), {0:.9f});
  vec3 luma = vec3(dot(v, vec3(0.2126, 0.7152, 0.0722)));
  v = min(luma + gradeSaturation * (v - luma), {0:.9f});
  return displayFromGrading(vec4(v, code.a));
}}
)",
                     highest);
}

}  // namespace

DisplayProgram::DisplayProgram(const ColorConfig& config, const std::string& colorSpace,
                               const DisplayChoice& choice) {
  const DisplayChoice shown = namedDisplay(config, choice);
  const ColorConfig::Impl& impl = config.impl();
  std::vector<OCIO::GpuShaderDescRcPtr> shaders;
  std::string text;
  const auto add = [&](const OCIO::ConstGPUProcessorRcPtr& processor, const char* function,
                       const char* prefix) {
    shaders.push_back(shaderOf(processor, function, prefix));
    text += shaders.back()->getShaderText();
  };
  try {
    if (shown.actingGrade()) {
      add(impl.shaderToGrading(colorSpace), "gradingFromScene", "grading_");
      add(impl.shaderViewFromGrading(colorSpace, shown), "displayFromGrading", "ocio_");
      text += gradeText(impl.highestGradingCode(colorSpace));
    } else {
      add(impl.shaderView(colorSpace, shown), "displayFromScene", "ocio_");
    }
  } catch (const OCIO::Exception& error) {
    throw InputError("{}: OpenColorIO writes no shader for {}: {}", config.name(), displayWords(shown),
                     error.what());
  }
  m_program = ShaderProgram(kVertex, kFragment, text);
  const TightPixels tight;
  for (const OCIO::GpuShaderDescRcPtr& shader : shaders) {
    for (Table& table : cubesOf(shader)) m_tables.push_back(std::move(table));
    for (Table& table : curvesOf(shader)) m_tables.push_back(std::move(table));
  }
  checkGl("for the tables of a view");
}

void DisplayProgram::setGrade(const ColorGrade& grade) const {
  const auto vec = [](const std::array<double, 3>& v) { return glm::vec3(v[0], v[1], v[2]); };
  m_program.set({{"gradeSlope", vec(grade.slope)},
                 {"gradeOffset", vec(grade.offset)},
                 {"gradePower", vec(grade.power)},
                 {"gradeSaturation", static_cast<float>(grade.saturation)}});
}

DisplayProgram DisplayProgram::forData() {
  DisplayProgram data;
  data.m_program = ShaderProgram(kVertex, kFragment, "vec4 displayFromScene(vec4 value) { return value; }\n");
  return data;
}

}  // namespace swaplight
