#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/shadow/result/shadow_mark.h"

namespace swaplight {

struct ShadowOptions {
  /// Where shadow begins: the shading over that of well-lit pixels, 0..1. Nothing: each light's own, found
  /// where the shadows' edges are.
  std::optional<float> threshold;
  /// The same for single lights, by name.
  std::map<std::string, float> thresholds;
  /// What a person says of single places, light by light. The search obeys it.
  ShadowMarksByLight marks;
  /// Shadows and holes in them of fewer pixels than this share of the picture are taken for noise.
  float smallestShare = 1e-4f;
  /// The one that is given for a light, if any.
  [[nodiscard]] std::optional<float> thresholdOf(const std::string& light) const {
    const auto own = thresholds.find(light);
    return own != thresholds.end() ? std::optional(own->second) : threshold;
  }
  [[nodiscard]] const ShadowMarks& marksOf(const std::string& light) const {
    static const ShadowMarks none;
    const auto own = marks.find(light);
    return own != marks.end() ? own->second : none;
  }
  bool operator==(const ShadowOptions&) const = default;
};

}  // namespace swaplight
