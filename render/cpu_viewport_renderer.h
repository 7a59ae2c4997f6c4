#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/image/pixel_rect.h"
#include "core/view/display/display_table.h"
#include "render/surface.h"
#include "render/viewport_renderer.h"

namespace swaplight {

/// Computes the window's pixels on the processor.
class CpuViewportRenderer : public ViewportRenderer {
 public:
  explicit CpuViewportRenderer(std::shared_ptr<const ColorConfig> config) : m_config(std::move(config)) {}

  unsigned texture(const ViewportRequest& request, int place) override;
  void changed(const Pyramid& picture, const TileRect& where) override;
  void setConfig(const std::shared_ptr<const ColorConfig>& config) override;
  [[nodiscard]] std::string words() const override;

 private:
  struct Place {
    std::optional<ViewportRequest> shown;
    PixelRect changed;  ///< of the picture, since it was drawn
    LayerSum sumA, sumB;
    std::vector<uint8_t> pixels;
    SurfaceTexture texture;
  };
  void drawAll(const ViewportRequest& request, Place& place);
  void drawChanged(Place& place);
  /// The pixels of a window, rows without gaps; `place` remembers sums where it is given.
  void draw(const ViewportRequest& request, const ViewWindow& window, Place* place, uint8_t* pixels);
  void drawB(const ViewportRequest& request, const ViewWindow& window, LayerSum* sum, uint8_t* pixels);
  const DisplayTable& tableFor(const std::string& colorSpace, const ViewSettings& settings);

  std::shared_ptr<const ColorConfig> m_config;   ///< what is made of it refers to it: it stays first
  std::map<std::string, DisplayTable> m_tables;  ///< by colour space
  std::map<int, Place> m_places;
};

}  // namespace swaplight
