#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/image/image.h"

namespace swaplight {

/// What a pixel is to a light.
enum class ShadowLabel : uint8_t {
  Unknown = 0,   ///< cannot be told: too dark, or shadow and dim light look alike
  Umbra = 1,     ///< the light does not reach it
  Penumbra = 2,  ///< part of the light does
  Lit = 3,
};

/// One light's shadows.
struct LightShadows {
  Image visibility;  ///< one channel, 0..1: how much of the light the pixel sees
  std::vector<ShadowLabel> labels;
  /// R G B, >= 0: what the light would add where nothing of it were hidden. contribution + (1 - visibility) *
  /// direct is the contribution without shadows.
  Image direct;
  float threshold = 0;  ///< the shading over that of well-lit pixels at which shadow was taken to begin
};

/// Finds a light's shadows on the set as solved; may take long the first time. Throws InputError for a name
/// that is not a light of the set.
using ShadowSource = std::function<std::shared_ptr<const LightShadows>(const std::string& light)>;

}  // namespace swaplight
