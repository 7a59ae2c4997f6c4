#include "render/display_program.h"

#include <epoxy/gl.h>

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

}  // namespace

DisplayProgram::DisplayProgram(const ColorConfig& config, const std::string& colorSpace,
                               const DisplayChoice& choice) {
  OCIO::GpuShaderDescRcPtr shader = OCIO::GpuShaderDesc::CreateShaderDesc();
  shader->setLanguage(OCIO::GPU_LANGUAGE_GLSL_4_0);
  shader->setFunctionName("displayFromScene");
  shader->setResourcePrefix("ocio_");
  try {
    config.impl().shaderView(colorSpace, namedDisplay(config, choice))->extractGpuShaderInfo(shader);
  } catch (const OCIO::Exception& error) {
    throw InputError("{}: OpenColorIO writes no shader for {}: {}", config.name(),
                     displayWords(namedDisplay(config, choice)), error.what());
  }
  m_program = ShaderProgram(kVertex, kFragment, shader->getShaderText());
  const TightPixels tight;
  m_tables = cubesOf(shader);
  for (Table& table : curvesOf(shader)) m_tables.push_back(std::move(table));
  checkGl("for the tables of a view");
}

DisplayProgram DisplayProgram::forData() {
  DisplayProgram data;
  data.m_program = ShaderProgram(kVertex, kFragment, "vec4 displayFromScene(vec4 value) { return value; }\n");
  return data;
}

}  // namespace swaplight
