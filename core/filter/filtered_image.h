#pragma once

#include "core/filter/filter.h"
#include "core/image/image.h"

namespace swaplight {

/// A picture, and what its values mean.
struct FilteredImage {
  Image image;                                   ///< R G B, or R G B A
  FilterSpace space = FilterSpace::SceneLinear;  ///< never Any
  /// R G B, a picture of the whole frame of any size: how much more light the lights of the set give there
  /// than they do at unit white (relativeLight). Empty where no lights are known.
  Image light = {};
};

}  // namespace swaplight
