#include "ui/tools/pointer.h"

#include <cmath>

namespace swaplight {

std::array<float, 2> pointAtMouse(const ViewWindow& window, ImVec2 origin) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  return {static_cast<float>(window.pictureX(mouse.x - origin.x)),
          static_cast<float>(window.pictureY(mouse.y - origin.y))};
}

std::optional<PicturePixel> pixelUnder(const EditingContext& studio, const ViewWindow& window,
                                       ImVec2 origin) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const PicturePixel pixel{static_cast<int>(std::floor(window.pictureX(mouse.x - origin.x))),
                           static_cast<int>(std::floor(window.pictureY(mouse.y - origin.y)))};
  const ViewPictures& pictures = studio.set()->pictures();
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= pictures.width() || pixel.y >= pictures.height())
    return std::nullopt;
  return pixel;
}

std::optional<PicturePixel> pixelAtMouse(const EditingContext& studio) {
  const ShownPicture& shown = studio.shown;
  if (!shown.valid || !shown.hovered) return std::nullopt;
  return pixelUnder(studio, shown.window, ImVec2(shown.originX, shown.originY));
}

}  // namespace swaplight
