#pragma once

namespace swaplight {

/// A tool for the mouse in the viewer, as actions, panels and state know it; there is one object of each, and
/// its address is compared. What the mouse does with it: ui/tools/picture_tool.h.
struct Tool {
  const char* id;  ///< of the action that takes it into the hand: "brush.take"
  const char* name;
  const char* keys;
  const char* tooltip;
  bool edits = false;  ///< makes edits: brings the list of them
};

/// nullptr: the hand itself, which moves the picture.
using ToolInHand = const Tool*;

}  // namespace swaplight
