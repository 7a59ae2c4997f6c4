#include "ui/tools/picture_tool.h"

#include <array>
#include <utility>

#include "ui/tools/brush_tool.h"
#include "ui/tools/handle_tool.h"
#include "ui/tools/lamp_tool.h"
#include "ui/tools/pick_tool.h"
#include "ui/tools/selection_tool.h"
#include "ui/tools/shadow_mark_tool.h"
#include "ui/tools/stencil_tool.h"

namespace swaplight {
namespace {

void take(EditingContext& studio, const Tool& tool) {
  studio.tool = studio.tool == &tool ? nullptr : &tool;
  if (!studio.tool || !tool.edits) return;
  studio.layout.edits = true;
  studio.edits.prepare();
}

}  // namespace

void addToolActions(ActionTable& actions, EditingContext& studio) {
  for (const PictureTool* picture : pictureTools())
    for (const Tool* tool : picture->tools) {
      if (!tool) continue;
      Action action{tool->id,
                    tool->name,
                    tool->keys,
                    tool->tooltip,
                    [&studio, tool] { take(studio, *tool); },
                    [&studio] { return studio.hasLights(); },
                    [&studio, tool] { return studio.tool == tool; }};
      action.keysTake = true;
      actions.add(std::move(action));
    }
}

std::span<const PictureTool* const> pictureTools() {
  // The handles of a shape go before laying on a new one. Picking comes last: it is what Alt makes of the
  // others.
  static constexpr std::array<const PictureTool*, 7> kTools = {
      &kSelectionTool, &kBrushTool, &kHandleTool, &kShadowMarkTool, &kLampTool, &kStencilTool, &kPickTool};
  return kTools;
}

}  // namespace swaplight
