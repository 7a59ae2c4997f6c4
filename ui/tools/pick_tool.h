#pragma once

#include "ui/tools/picture_tool.h"

namespace swaplight {

/// A click gives the chosen lights the colour that makes a pixel neutral, or that pixel's colour.
extern const PictureTool kPickTool;

}  // namespace swaplight
