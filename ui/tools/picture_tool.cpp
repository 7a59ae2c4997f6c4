#include "ui/tools/picture_tool.h"

#include <array>

#include "ui/tools/brush_tool.h"
#include "ui/tools/handle_tool.h"
#include "ui/tools/pick_tool.h"
#include "ui/tools/selection_tool.h"
#include "ui/tools/stencil_tool.h"

namespace swaplight {

std::span<const PictureTool* const> pictureTools() {
  // The handles of a shape go before laying on a new one. Picking comes last: it is what Alt makes of the
  // others.
  static constexpr std::array<const PictureTool*, 5> kTools = {&kSelectionTool, &kBrushTool, &kHandleTool,
                                                               &kStencilTool, &kPickTool};
  return kTools;
}

}  // namespace swaplight
