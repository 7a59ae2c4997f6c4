#include "ui/tools/edit_tool.h"

namespace swaplight {

void takeEditTool(EditingContext& studio, Tool tool) {
  studio.tool = studio.tool == tool ? Tool::Look : tool;
  if (studio.tool != tool) return;
  studio.layout.edits = true;
  studio.edits.prepare();
}

}  // namespace swaplight
