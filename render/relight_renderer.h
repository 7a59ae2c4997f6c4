#pragma once

#include <span>
#include <vector>

#include "core/color/rgb.h"
#include "core/image/image.h"
#include "core/set/solved_set.h"
#include "render/gl/tiled_texture.h"
#include "render/layer_renderer.h"

namespace swaplight {

struct RelightRendererOptions {
  int maxTextureSide = 0;  ///< pixels; 0: what the graphics card allows. Larger pictures are tiled
  int lightsPerPass = LayerRenderer::kLayersPerPass;
  size_t memoryLimit = 0;  ///< bytes for all textures; 0: until the graphics card refuses
};

/// Relights a set on the graphics card: the contributions lie there as half floats, and a frame is their sum
/// under each light's factor, at the picture's resolution, in half floats. Within 2e-3 of core's relight() in
/// 0..2, up to 16 lights. Needs a current OpenGL 4.1 context, in which it must also be destroyed.
class RelightRenderer {
 public:
  /// Uploads the set's contributions and ambient. Throws ResourceError, in words, where they do not fit.
  explicit RelightRenderer(const SolvedSet& set, const RelightRendererOptions& options = {});

  [[nodiscard]] int width() const { return m_frame.width; }
  [[nodiscard]] int height() const { return m_frame.height; }
  [[nodiscard]] int lightCount() const { return m_lightCount; }

  /// Replaces a rectangle of one light's contribution by `pixels` (R G B), whose left top pixel lies at x, y.
  void updateContribution(int light, ImageView pixels, int x, int y);
  /// The same for the ambient light, which the set must have.
  void updateAmbient(ImageView pixels, int x, int y);

  /// Draws the frame: sum of factors[i] * T[i] + ambientFactor * ambient. Valid until the next call.
  TiledTexture& relight(std::span<const Rgb> factors, float ambientFactor = 1);
  [[nodiscard]] const TiledTexture& frame() const { return m_frame; }

  /// The last frame as an image.
  [[nodiscard]] Image readback() const;

 private:
  int m_lightCount;
  LayerRenderer m_layers;
  std::vector<TiledTexture> m_pictures;  ///< the contributions, then the ambient light if there is one
  TiledTexture m_frame;
};

}  // namespace swaplight
