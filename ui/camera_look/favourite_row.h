#pragma once

#include "ui/camera_look/look_menu.h"

namespace swaplight {

/// The favourite camera looks as buttons, in a line or two: a click sees the picture through one, another
/// click without it. What finds no room, and all other looks, are behind the last button.
void drawFavouriteRow(const LookChoice& studio);

}  // namespace swaplight
