#pragma once

#include "core/filter/filter.h"
#include "core/image/image.h"

namespace swaplight {

/// A picture, and what its values mean.
struct FilteredImage {
  Image image;                                   ///< R G B, or R G B A
  FilterSpace space = FilterSpace::SceneLinear;  ///< never Any
};

}  // namespace swaplight
