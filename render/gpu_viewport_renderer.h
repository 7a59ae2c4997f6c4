#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "render/layer_renderer.h"
#include "render/view_renderer.h"
#include "render/view_target.h"
#include "render/viewport_renderer.h"

namespace swaplight {

/// Computes the window's pixels by shaders. Keeps every picture that was shown on the graphics card, as half
/// floats, until something else is drawn after it was destroyed.
class GpuViewportRenderer : public ViewportRenderer {
 public:
  explicit GpuViewportRenderer(std::shared_ptr<const ColorConfig> config) : m_config(std::move(config)) {}

  unsigned texture(const ViewportRequest& request, int place) override;
  void changed(const Pyramid& picture, const TileRect& where) override;
  void setConfig(const std::shared_ptr<const ColorConfig>& config) override;
  [[nodiscard]] std::string words() const override;

 private:
  /// A sum of pictures, kept while only the view of it changes.
  struct Frame {
    std::vector<ViewLayer> layers;
    TiledTexture picture;
  };
  struct Place {
    std::optional<ViewportRequest> shown;
    Frame a, b;
    ViewTarget target;
  };
  void draw(const ViewportRequest& request, Place& place);
  TiledTexture& relit(Frame& frame, const std::vector<ViewLayer>& layers);
  const TiledTexture& uploaded(const Pyramid& picture);
  ViewRenderer& viewerFor(const std::string& colorSpace);

  std::shared_ptr<const ColorConfig> m_config;  ///< what is made of it refers to it: it stays first
  LayerRenderer m_layers;
  std::map<PictureIdentity, TiledTexture, std::owner_less<>> m_pictures;
  std::map<std::string, ViewRenderer> m_viewers;  ///< by colour space
  std::map<int, Place> m_places;
};

}  // namespace swaplight
