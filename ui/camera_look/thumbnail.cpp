#include "ui/camera_look/thumbnail.h"

#include <algorithm>
#include <cmath>

#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {

void drawThumbnail(ViewerContext& studio, const std::string& key, const FilterPipeline& look, ImVec2 low,
                   ImVec2 high) {
  const OpenSet* set = studio.set();
  if (!set) return;
  const float wide =
      static_cast<float>(set->pictures().width()) / static_cast<float>(std::max(set->pictures().height(), 1));
  const float height = std::min(high.y - low.y, (high.x - low.x) / wide);
  const LookThumbnails::Shown shown =
      studio.thumbnails.picture(key, look, std::max(1, static_cast<int>(height)));
  const ImVec2 size = shown.texture == 0
                          ? ImVec2(std::floor(height * wide), std::floor(height))
                          : ImVec2(static_cast<float>(shown.width), static_cast<float>(shown.height));
  // On whole pixels, where the texture's fall on the screen's.
  const ImVec2 at(std::floor((low.x + high.x - size.x) / 2), std::floor((low.y + high.y - size.y) / 2));
  const ImVec2 to(at.x + size.x, at.y + size.y);
  if (shown.texture == 0)
    ImGui::GetWindowDrawList()->AddRectFilled(at, to, kViewerGround);
  else
    drawTexture(shown.texture, at, to);
}

}  // namespace swaplight
