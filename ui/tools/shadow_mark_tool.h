#pragma once

#include "ui/tools/picture_tool.h"

namespace swaplight {

/// A click says of a place that the chosen light does not reach it, or does: the search for shadows obeys.
extern const PictureTool kShadowMarkTool;

}  // namespace swaplight
