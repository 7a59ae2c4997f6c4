#pragma once

#include <memory>

#include "core/edit/edit.h"
#include "core/shadow/light_shadows.h"

namespace swaplight {

/// What a shadow operation does to a light's contribution T, pixel by pixel, with a mask m:
/// T + m * weight * color * direct, at least 0; or where `multiplies`: T * (1 + m * weight).
struct ShadowChange {
  std::shared_ptr<const LightShadows> shadows;
  std::shared_ptr<const Image> weight;  ///< one channel, -1..1
  Rgb color{1, 1, 1};
  bool multiplies = false;
};

[[nodiscard]] ShadowChange shadowChange(const ShadowOperation& operation,
                                        std::shared_ptr<const LightShadows> shadows);

}  // namespace swaplight
