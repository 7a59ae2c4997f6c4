#pragma once

namespace swaplight {

// A tooltip comes when the mouse has kept still over an item for half a second, stays while it is over that
// item, and goes with the first click. (Dear ImGui's own timer starts anew in every frame where items
// overlap.)

/// To be called at the beginning of every frame, once Dear ImGui's is open.
void tooltipClockFrame();
/// The item under the mouse may say what it does.
[[nodiscard]] bool tooltipDue();
/// Until it may, if nothing happens; infinity where it does already, or will not.
[[nodiscard]] double secondsToTooltip();

}  // namespace swaplight
