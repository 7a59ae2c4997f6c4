#include "ui/tools/edit_tool.h"

namespace swaplight {

void takeEditTool(StudioContext& studio, Tool tool) {
  studio.tool = studio.tool == tool ? Tool::Look : tool;
  if (studio.tool != tool) return;
  studio.layout.edits = true;
  studio.edits.prepare(studio);
}

}  // namespace swaplight
