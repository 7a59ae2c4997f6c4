#pragma once

#include "ui/jobs/messages.h"

namespace swaplight {

/// Draws the messages in the lower left corner of a rectangle of the screen.
void drawMessages(Messages& messages, float left, float bottom, float maxWidth);

}  // namespace swaplight
