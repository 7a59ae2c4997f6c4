#pragma once

#include <optional>
#include <string>

#include "core/look/light_ratios.h"
#include "core/relight/rig.h"

namespace swaplight {

/// What three-point panel and gallery remember between frames and nobody saves.
struct LookState {
  LightRatios ratios;        ///< of the open set
  uint64_t ratiosOfSet = 0;  ///< which one

  /// A preset that was applied, and can be blended with what was before until something else changes.
  struct Blend {
    std::string name;
    Rig before, whole;
    Rig shown;  ///< what the blending made last
    float amount = 1;
  };
  std::optional<Blend> blend;

  size_t sideA = 0, sideB = 1;  ///< looks at the ends of the T-bar
  float fader = 0;
  size_t edited = 0;  ///< the look whose name and note are being typed
  std::string name, note;
};

}  // namespace swaplight
