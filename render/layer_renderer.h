#pragma once

#include <map>
#include <span>

#include "core/color/rgb.h"
#include "render/gl/shader_program.h"
#include "render/gl/tiled_texture.h"

namespace swaplight {

/// One addend of a picture: a picture on the graphics card, times a factor.
struct TextureLayer {
  const TiledTexture* picture = nullptr;
  Rgb factor{1, 1, 1};
};

/// Adds up pictures on the graphics card: what relighting is.
class LayerRenderer {
 public:
  /// Pictures that one pass adds up: what every OpenGL 4.1 can read at a time.
  static constexpr int kLayersPerPass = 16;

  /// `layersPerPass`: 1..16. More layers are added in further passes, each of which rounds to half floats.
  explicit LayerRenderer(int layersPerPass = kLayersPerPass);

  /// out = sum of factor * picture. All pictures have the same size and tiles as `out`.
  void draw(std::span<const TextureLayer> layers, TiledTexture& out);

 private:
  const ShaderProgram& programFor(size_t pictures);

  int m_layersPerPass;
  std::map<size_t, ShaderProgram> m_programs;  ///< by the number of pictures that one adds up
  GlVertexArray m_vertexArray;
};

}  // namespace swaplight
