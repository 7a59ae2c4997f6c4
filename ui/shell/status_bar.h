#pragma once

#include "ui/control/session_controller.h"
#include "ui/state/color_choice.h"
#include "ui/state/shown_picture.h"

namespace swaplight {

/// One line along the bottom: what is open, what is under the mouse, how large it is shown.
void drawStatusBar(const SessionController& session, const ShownPicture& shown, const ColorChoice& colors);

}  // namespace swaplight
