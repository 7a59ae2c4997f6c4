#pragma once

#include <optional>

namespace swaplight {

struct ShadowOptions {
  /// Where shadow begins: the shading over that of well-lit pixels, 0..1. Nothing: each light's own, found
  /// where the shadows' edges are.
  std::optional<float> threshold;
  /// Shadows and holes in them of fewer pixels than this share of the picture are taken for noise.
  float smallestShare = 1e-4f;
  bool operator==(const ShadowOptions&) const = default;
};

}  // namespace swaplight
