#include "render/view_renderer.h"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/view/false_color.h"
#include "core/view/luminance.h"
#include "render/gl_info.h"
#include "render/gl_scope.h"

namespace swaplight {
namespace {

void setFalseColor(const ShaderProgram& program, bool on, const Rgb& luminanceWeights) {
  std::vector<float> stops;
  std::vector<glm::vec3> colors;
  for (const FalseColorBand& band : falseColorBands()) {
    stops.push_back(std::max(band.stops, -1000.0F));
    colors.push_back(band.color);
  }
  program.set({{"falseColor", on ? 1 : 0},
               {"bandCount", static_cast<int>(stops.size())},
               {"bandStops", std::span<const float>(stops)},
               {"bandColors", std::span<const glm::vec3>(colors)},
               {"luminanceWeights", luminanceWeights}});
}

/// Fills a tile's halved pictures, which are made from it by averaging.
void halve(const TiledTexture::Tile& tile) {
  const BoundTexture bound(0, GL_TEXTURE_2D, tile.texture.id());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
}

}  // namespace

ViewRenderer::ViewRenderer(const ColorConfig& config, std::string colorSpace)
    : m_config(config),
      m_colorSpace(std::move(colorSpace)),
      m_luminanceWeights(luminanceWeights(config, m_colorSpace)),
      m_vertexArray(GlVertexArray::make()) {}

unsigned ViewRenderer::draw(TiledTexture& picture, const ViewWindow& window, const ViewSettings& settings) {
  const std::string display = settings.display.empty() ? m_config.defaultDisplay() : settings.display;
  const std::string view = settings.view.empty() ? m_config.defaultView(display) : settings.view;
  auto found = m_programs.find({display, view});
  if (found == m_programs.end())
    found = m_programs.try_emplace({display, view}, m_config, m_colorSpace, display, view).first;
  return drawWith(found->second, picture, window, settings);
}

unsigned ViewRenderer::drawData(TiledTexture& picture, const ViewWindow& window,
                                const ViewSettings& settings) {
  if (!m_data.program()) m_data = DisplayProgram::forData();
  return drawWith(m_data, picture, window, settings);
}

unsigned ViewRenderer::drawWith(const DisplayProgram& display, TiledTexture& picture,
                                const ViewWindow& window, const ViewSettings& settings) {
  resize(window.width, window.height);
  const bool smoothed = !showsSquares(window.zoom);
  if (smoothed && !picture.halved) {
    for (const TiledTexture::Tile& tile : picture.tiles) halve(tile);
    picture.halved = true;
  }

  const OverwriteState overwrite;
  const BoundFramebuffer target(m_framebuffer.id(), m_width, m_height);
  const BoundProgram bound(display.program().id(), m_vertexArray.id());
  const ShaderProgram& program = display.program();
  BoundTextures tables;
  tables.add(GL_TEXTURE_2D, 0);  // the tiles' place
  for (const DisplayProgram::Table& table : display.tables())
    program.set({{table.sampler, tables.add(table.target, table.texture.id())}});
  program.set({{"picture", 0},
               {"windowOrigin", glm::vec2(window.left, window.top)},
               {"zoom", static_cast<float>(window.zoom)},
               {"level", nearestLevel(window.zoom)},
               {"smoothed", smoothed ? 1 : 0},
               {"exposureFactor", std::exp2(settings.exposureStops)},
               {"gamma", settings.gamma},
               {"channel", static_cast<int>(settings.channel)},
               {"zebra", settings.zebra.on ? 1 : 0},
               {"zebraLow", settings.zebra.low},
               {"zebraHigh", settings.zebra.high}});
  setFalseColor(program, settings.falseColor, m_luminanceWeights);
  const std::array<float, 4> transparent{};
  glClearBufferfv(GL_COLOR, 0, transparent.data());
  for (const TiledTexture::Tile& tile : picture.tiles) {
    const BoundTexture texture(0, GL_TEXTURE_2D, tile.texture.id());
    program.set({{"tileOrigin", glm::ivec2(tile.rect.x, tile.rect.y)},
                 {"tileSize", glm::ivec2(tile.rect.width, tile.rect.height)}});
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  checkGl("while a picture is shown");
  return m_target.id();
}

void ViewRenderer::resize(int width, int height) {
  if (m_target && width == m_width && height == m_height) return;
  m_width = width;
  m_height = height;
  m_target = GlTexture::make();
  m_framebuffer = GlFramebuffer::make();
  const BoundTexture texture(0, GL_TEXTURE_2D, m_target.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  const BoundFramebuffer bound(m_framebuffer.id(), width, height);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_target.id(), 0);
  checkGl(fmt::format("for a viewer of {} x {}", width, height));
}

std::vector<uint8_t> ViewRenderer::readback() const {
  std::vector<uint8_t> pixels(static_cast<size_t>(m_width) * static_cast<size_t>(m_height) * 4);
  const TightPixels tight;
  const BoundFramebuffer source(m_framebuffer.id(), m_width, m_height);
  glReadPixels(0, 0, m_width, m_height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

}  // namespace swaplight
