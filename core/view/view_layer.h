#pragma once

#include "core/color/rgb.h"
#include "core/view/pyramid.h"

namespace swaplight {

/// One addend of what is shown: a picture of three channels, or of one that counts for all three, times a
/// factor.
struct ViewLayer {
  ViewLayer(const Pyramid* shown, const Rgb& times = Rgb(1))
      : picture(shown), factor(times), life(shown ? shown->life() : PictureLife{}) {}

  const Pyramid* picture;
  Rgb factor;
  PictureLife life;  ///< the picture's
  /// The same picture, which may lie elsewhere now: only the newest of equal layers tells where.
  bool operator==(const ViewLayer& other) const {
    return isSamePicture(life, other.life) && factor == other.factor;
  }
};

}  // namespace swaplight
