#include "render/view_renderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/ocio/luminance.h"
#include "core/view/display/false_color.h"
#include "render/gl/gl_info.h"
#include "render/gl/gl_scope.h"

namespace swaplight {
namespace {

/// Stands for every grade: a program draws with any.
const ColorGrade kAnyGrade{true, {1, 1, 1}, {0, 0, 0}, {1, 1, 1}, 0};

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
      m_luminanceWeights(m_colorSpace.empty() ? kRec709Luminance : luminanceWeights(config, m_colorSpace)),
      m_vertexArray(GlVertexArray::make()) {}

const DisplayProgram& ViewRenderer::programFor(const ViewSettings& settings) {
  if (m_colorSpace.empty()) {
    const auto found = m_programs.find({});
    return found != m_programs.end() ? found->second
                                     : m_programs.try_emplace({}, DisplayProgram::forData()).first->second;
  }
  DisplayChoice choice = namedDisplay(m_config, settings.display);
  if (choice.actingGrade())
    choice.grade = kAnyGrade;
  else
    choice.grade.reset();
  const auto found = m_programs.find(choice);
  if (found != m_programs.end()) return found->second;
  return m_programs.try_emplace(choice, m_config, m_colorSpace, choice).first->second;
}

void ViewRenderer::draw(TiledTexture& picture, const ViewWindow& window, const ViewSettings& settings,
                        ViewTarget& target) {
  target.resize(window.width, window.height);
  {
    const BoundFramebuffer bound(target.framebuffer(), target.width(), target.height());
    const OverwriteState overwrite;
    const std::array<float, 4> transparent{};
    glClearBufferfv(GL_COLOR, 0, transparent.data());
  }
  draw(picture, window, settings, Part(), target);
}

void ViewRenderer::draw(TiledTexture& picture, const ViewWindow& window, const ViewSettings& settings,
                        const Part& part, ViewTarget& target) {
  const DisplayProgram& display = programFor(settings);
  const ShaderProgram& program = display.program();
  const bool smoothed = !showsSquares(window);
  if (smoothed && !picture.halved) {
    for (const TiledTexture::Tile& tile : picture.tiles) halve(tile);
    picture.halved = true;
  }

  const OverwriteState overwrite;
  const BoundFramebuffer framebuffer(target.framebuffer(), target.width(), target.height());
  const BoundProgram bound(program.id(), m_vertexArray.id());
  BoundTextures tables;
  tables.add(GL_TEXTURE_2D, 0);  // the tiles' place
  for (const DisplayProgram::Table& table : display.tables())
    program.set({{table.sampler, tables.add(table.target, table.texture.id())}});
  program.set({{"picture", 0},
               {"windowOrigin", glm::vec2(window.left, window.top)},
               {"zoom", static_cast<float>(window.zoom)},
               {"level", nearestLevel(window.zoom)},
               {"smoothed", smoothed ? 1 : 0},
               {"side", part.side},
               {"absolute", part.absolute ? 1 : 0},
               {"exposureFactor", std::exp2(settings.exposureStops)},
               {"gamma", settings.gamma},
               {"channel", static_cast<int>(settings.channel)},
               {"zebra", settings.zebra.on ? 1 : 0},
               {"zebraLow", settings.zebra.low},
               {"zebraHigh", settings.zebra.high}});
  const ColorGrade* grade = settings.display.actingGrade();
  if (grade && !m_colorSpace.empty()) display.setGrade(*grade);
  setFalseColor(program, settings.falseColor, m_luminanceWeights);
  for (const TiledTexture::Tile& tile : picture.tiles) {
    const BoundTexture texture(0, GL_TEXTURE_2D, tile.texture.id());
    program.set({{"tileOrigin", glm::ivec2(tile.rect.x, tile.rect.y)},
                 {"tileSize", glm::ivec2(tile.rect.width, tile.rect.height)}});
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  checkGl("while a picture is shown");
}

}  // namespace swaplight
