#pragma once

#include <optional>
#include <vector>

#include "render/surface.h"
#include "ui/control/lights_context.h"
#include "ui/mixer/version_pictures.h"

namespace swaplight {

/// The looks that were kept, below the viewer: one click lights the set so; wipe, crossfade, names, notes.
class GalleryPanel {
 public:
  void draw(LightsContext& studio);
  /// Its height at scale 1.
  static constexpr float kHeight = 142;

 private:
  /// A look's picture and what it was made of.
  struct Thumbnail {
    Rig rig;
    std::optional<VersionScene> scene;
    uint64_t set = 0;
    std::shared_ptr<const DisplayTable> table;
    SurfaceTexture texture;
  };
  unsigned thumbnail(LightsContext& studio, size_t index, int width, int height);
  static void drawKeepButtons(const LightsContext& studio, float width, float height);
  void drawLook(LightsContext& studio, size_t index, float height);

  std::vector<Thumbnail> m_thumbnails;
  VersionPictures m_versions;
};

}  // namespace swaplight
