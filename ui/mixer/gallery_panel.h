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
  explicit GalleryPanel(std::function<void()> wake) : m_versions(std::move(wake)) {}
  void draw(LightsContext& studio);
  /// To be called often.
  void update(Messages& messages) { m_versions.update(messages); }
  /// Pictures of versions are being made.
  [[nodiscard]] bool busy() const { return m_versions.busy(); }
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
  /// The last picture as long as another one is being made; 0 where there is none.
  unsigned thumbnail(LightsContext& studio, size_t index, int width, int height);
  static void drawKeepButtons(const LightsContext& studio, float width, float height);
  void drawLook(LightsContext& studio, size_t index, float height);

  std::vector<Thumbnail> m_thumbnails;
  VersionPictures m_versions;
};

}  // namespace swaplight
