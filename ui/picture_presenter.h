#pragma once

#include <optional>
#include <vector>

#include "core/view/display_table.h"
#include "core/view/layer_sum.h"
#include "core/view/view_settings.h"
#include "core/view/window_pixels.h"
#include "render/screen.h"
#include "ui/view_pictures.h"

namespace swaplight {

/// Makes the texture that the viewer draws; again only when something of what it shows has changed.
class PicturePresenter {
 public:
  struct Request {
    const ViewPictures* pictures = nullptr;
    uint64_t setRevision = 0;
    ViewSubject subject;
    std::vector<Rgb> factors;
    float ambientFactor = 1;
    ViewWindow window;  ///< inside of the picture
    ViewSettings settings;
    std::string colorSpace;
    bool operator==(const Request&) const = default;
  };

  /// The texture of window.width x window.height pixels.
  unsigned texture(const Request& request);

 private:
  std::optional<Request> m_shown;
  std::optional<DisplayTable> m_table;
  LayerSum m_sum;
  std::vector<uint8_t> m_pixels;
  ScreenTexture m_texture;
};

}  // namespace swaplight
