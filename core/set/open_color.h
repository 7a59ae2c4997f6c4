#pragma once

#include <string>

#include "core/color/rgb.h"

namespace swaplight {

/// An unknown colour of which the photographs leave one number open: all colours of a line explain them
/// equally well.
struct OpenColor {
  std::string name;      ///< as a person knows it: "?a (fill in shot 1, key in shot 2)"
  Rgb nearest{0};        ///< the line's end that is most like the known colour
  Rgb farthest{0};       ///< the other one
  Rgb taken{0};          ///< what was solved with
  float position = 0;    ///< of `taken`: 0 at the nearest, 1 at the farthest
  Rgb exchanged{0};      ///< what fits equally well with the lamps exchanged: known^2 / taken
  std::string by;        ///< what has chosen it, in words
  bool settled = false;  ///< by something that the person has told, not by default
};

}  // namespace swaplight
