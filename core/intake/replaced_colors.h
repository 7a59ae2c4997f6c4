#pragma once

#include <vector>

#include "core/intake/shot_color.h"

namespace swaplight {

/// The capture with other colours for the gels of its first shot: each light's, wherever it went. In another
/// shot the gel is taken to be where the capture has the same name, or the colour that is nearest to it and
/// within a fifth (lamps differ a little); what is like none of them stays. Throws InputError: not one colour
/// a light, or one of the first shot is unknown and has no name, so that nothing says where it went.
[[nodiscard]] Capture withReplacedColors(Capture capture, const std::vector<ShotColor>& colors);

}  // namespace swaplight
