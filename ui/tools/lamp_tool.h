#pragma once

#include "ui/tools/picture_tool.h"

namespace swaplight {

/// Drags the middle of a light's pool where the chosen edit of the list moves or turns its lamp: the lamp
/// follows; or, where it places the lamp, the direction to it, as a place on a ball. Draws where it was and
/// is, and hatches where the new light is a guess.
extern const PictureTool kLampTool;

}  // namespace swaplight
