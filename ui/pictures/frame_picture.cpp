#include "ui/pictures/frame_picture.h"

#include "core/session/document.h"
#include "core/view/window_pixels.h"

namespace swaplight {

SmallPicture framePicture(const SolvedSet& set, const ViewPictures& pictures, const ColorConfig& config,
                          const DisplayTable& table, const Rig& rig, int width, int height) {
  const ViewWindow window{0, 0, fitZoom(pictures.width(), pictures.height(), width, height), width, height};
  SmallPicture picture{width, height,
                       std::vector<uint8_t>(4 * static_cast<size_t>(width) * static_cast<size_t>(height))};
  windowPixels(
      pictures.layers({}, rigFactors(config, fitRig(rig, set.capture), set.colorSpace()), rig.ambient),
      window,
      [&](const float* r, const float* g, const float* b, int count, uint8_t* rgba) {
        table.apply(r, g, b, count, rgba);
      },
      picture.rgba.data());
  return picture;
}

}  // namespace swaplight
