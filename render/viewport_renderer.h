#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/ocio/color_config.h"
#include "core/view/comparison.h"
#include "core/view/display/view_settings.h"
#include "core/view/view_window.h"
#include "core/view/window_pixels.h"
#include "render/gl/tiled_texture.h"

namespace swaplight {

/// Pictures that are added up and shown as one.
struct LayeredPicture {
  std::vector<ViewLayer> layers;  ///< of one size
  std::string colorSpace;         ///< of the layers, linear; empty: they are data, shown without a view
  double scale = 1;  ///< the layers' size in that of the picture: below 1 they are a draft that stands for it
  bool operator==(const LayeredPicture&) const = default;
};

/// What is to be seen in a window.
struct ViewportRequest {
  LayeredPicture a;
  LayeredPicture b;  ///< where the comparison is not Off; of A's size, for a difference of its scale, too
  Comparison comparison;
  ViewWindow window;  ///< of the picture, whatever the layers' scale
  ViewSettings settings;
  bool operator==(const ViewportRequest&) const = default;
};

/// Who computes what the viewer shows.
enum class Engine {
  Auto,       ///< the graphics card, unless what calls itself one is software
  Graphics,   ///< shaders
  Processor,  ///< core/view, at the size shown; the result is uploaded
};

/// Makes textures of what is to be seen, and caches what it made of pictures as long as these exist. Needs
/// the OpenGL context in which it was made.
class ViewportRenderer {
 public:
  ViewportRenderer() = default;
  ViewportRenderer(const ViewportRenderer&) = delete;
  ViewportRenderer& operator=(const ViewportRenderer&) = delete;
  virtual ~ViewportRenderer() = default;

  /// A texture of the window's size, row 0 at the top, transparent where there is no picture; does nothing
  /// where the request is that of the last call. Several windows at a time are told apart by their place.
  /// Throws InputError (unknown view), ResourceError (no memory).
  virtual unsigned texture(const ViewportRequest& request, int place = 0) = 0;

  /// To be called when pixels of a picture have changed, after its pyramid was refreshed.
  virtual void changed(const Pyramid& picture, const TileRect& where) = 0;
  /// From now on views are those of this configuration.
  virtual void setConfig(const std::shared_ptr<const ColorConfig>& config) = 0;

  /// Who computes, in words.
  [[nodiscard]] virtual std::string words() const = 0;
};

[[nodiscard]] std::unique_ptr<ViewportRenderer> makeViewportRenderer(
    Engine engine, std::shared_ptr<const ColorConfig> config);

}  // namespace swaplight
