#pragma once

#include <string>

#include "core/image/image.h"

namespace swaplight {

/// Tone mapping that looks at the whole picture, for stills: two frames of a sequence would not fit together.
/// The curves that are views (core/ocio/tone_curve.h) have no such limit.
struct StillTone {
  enum class Operator {
    Drago,    ///< Drago et al., "Adaptive logarithmic mapping for displaying high contrast scenes", 2003
    Mantiuk,  ///< Mantiuk et al., "A perceptual framework for contrast processing of HDR images", 2006
    Reinhard  ///< Reinhard and Devlin, "Dynamic range reduction inspired by photoreceptor physiology", 2005
  };
  Operator mapping = Operator::Drago;
  float saturation = 1;  ///< Drago, Mantiuk: 0..2
  float bias = 0.85F;    ///< Drago: 0.5..1; lower is brighter in the shadows
  float scale = 0.7F;    ///< Mantiuk: 0.1..1; of contrasts
  float intensity = 0;   ///< Reinhard: -8..8; higher is brighter
  float adapt = 1;       ///< Reinhard: 0..1; to each pixel (1) or to the whole picture (0)
  float colorAdapt = 0;  ///< Reinhard: 0..1; each channel for itself (1) or all together (0)
  bool operator==(const StillTone&) const = default;
};

/// NAME or NAME:PARAMETER=VALUE,...: drago (bias, saturation), mantiuk (scale, saturation), reinhard
/// (intensity, adapt, color_adapt). Throws InputError that lists what is known, and the range.
[[nodiscard]] StillTone stillToneFromText(const std::string& text);

/// In place: R, G, B of scene-linear Rec.709 to display-linear Rec.709, 0..1. What is not finite or is
/// negative counts as 0, infinity as the largest half float. By OpenCV.
void applyStillTone(ImageSpan picture, const StillTone& tone);

}  // namespace swaplight
