#include "core/shadow/result/shadow_outline.h"

#include "core/shadow/result/label_mask.h"

namespace swaplight {

ShadowOutlines shadowOutlines(const std::vector<ShadowLabel>& labels, int width, float scale,
                              float tolerance) {
  return {outlinesOfMask(labelMask(labels, width, ShadowLabel::Umbra), scale, tolerance),
          outlinesOfMask(labelMask(labels, width, ShadowLabel::Penumbra), scale, tolerance)};
}

}  // namespace swaplight
