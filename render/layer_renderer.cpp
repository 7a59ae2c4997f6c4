#include "render/layer_renderer.h"

#include <epoxy/gl.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <vector>

#include "render/gl/gl_info.h"
#include "render/gl/gl_scope.h"

namespace swaplight {

LayerRenderer::LayerRenderer(int layersPerPass)
    : m_layersPerPass(std::clamp(layersPerPass, 1, kLayersPerPass)), m_vertexArray(GlVertexArray::make()) {}

const ShaderProgram& LayerRenderer::programFor(size_t pictures) {
  const auto found = m_programs.find(pictures);
  if (found != m_programs.end()) return found->second;
  return m_programs
      .try_emplace(pictures, "fullscreen.vert", "relight.frag",
                   fmt::format("const int kPictures = {};", pictures))
      .first->second;
}

void LayerRenderer::draw(std::span<const TextureLayer> layers, TiledTexture& out) {
  std::vector<glm::vec3> factors;
  for (const TextureLayer& layer : layers) factors.push_back(layer.factor);
  std::vector<int> units(kLayersPerPass);
  std::iota(units.begin(), units.end(), 0);

  const OverwriteState overwrite;
  for (size_t t = 0; t < out.tiles.size(); ++t) {
    const TiledTexture::Tile& tile = out.tiles[t];
    const BoundFramebuffer target(tile.framebuffer.id(), tile.rect.width, tile.rect.height);
    if (layers.empty()) {
      const std::array<float, 4> black{0, 0, 0, 1};
      glClearBufferfv(GL_COLOR, 0, black.data());
    }
    std::optional<AdditiveBlending> adding;
    for (size_t done = 0; done < layers.size();) {
      const size_t count = std::min(layers.size() - done, static_cast<size_t>(m_layersPerPass));
      const ShaderProgram& program = programFor(count);
      const BoundProgram bound(program.id(), m_vertexArray.id());
      BoundTextures pictures;
      for (const TextureLayer& layer : layers.subspan(done, count))
        pictures.add(GL_TEXTURE_2D, layer.picture->tiles[t].texture.id());
      program.set({{"pictures", std::span<const int>(units).first(count)},
                   {"factors", std::span<const glm::vec3>(factors).subspan(done, count)}});
      glDrawArrays(GL_TRIANGLES, 0, 3);
      done += count;
      if (!adding) adding.emplace();  // what follows is added to it
    }
  }
  out.halved = false;
  checkGl("while relighting");
}

}  // namespace swaplight
