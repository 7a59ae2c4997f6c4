#pragma once

#include "core/color/rgb.h"
#include "core/view/pyramid.h"

namespace swaplight {

/// One addend of what is shown: a picture of three channels, or of one that counts for all three, times a
/// factor.
struct ViewLayer {
  ViewLayer(const Pyramid* shown, const Rgb& times = Rgb(1))
      : picture(shown), factor(times), identity(shown ? shown->identity() : PictureIdentity{}) {}

  const Pyramid* picture;
  Rgb factor;
  PictureIdentity identity;  ///< the picture's
  /// The same picture and factor. The picture may have been moved: only the newest of equal layers has its
  /// address.
  bool operator==(const ViewLayer& other) const {
    return isSamePicture(identity, other.identity) && factor == other.factor;
  }
};

}  // namespace swaplight
