#include "ui/edits/edits_actions.h"

#include <fmt/core.h>

#include <algorithm>

#include "ui/tools/brush_tool.h"
#include "ui/tools/edit_tool.h"

namespace swaplight {
namespace {

constexpr float kSizeStep = 1.25F;
constexpr float kHardnessStep = 0.1F;

}  // namespace

void addBrushActions(ActionTable& actions, EditingContext& studio) {
  const auto hasLights = [&studio] { return studio.set() && !studio.document().rig.lights.empty(); };
  const auto painting = [&studio, hasLights] { return studio.tool == Tool::Brush && hasLights(); };
  BrushState& brush = studio.editing.brush;
  actions.add({"edit.cancel_drag", "Take the drag back", "Escape",
               "While the button is held: the stroke, stencil, handle or lasso as if it had never begun.",
               [&studio] {
                 studio.editor.cancel();
                 studio.editing.endDrags();
               },
               [&studio] { return studio.editing.dragging(); }});
  actions.add(
      {"brush.take", "Paint with light", "Shift+B",
       "Paint on the picture with the chosen light: more of it, less, softer; again: put the brush away.",
       [&studio] { takeEditTool(studio, Tool::Brush); }, hasLights,
       [&studio] { return studio.tool == Tool::Brush; }});
  actions.add({"brush.new_light", "New light by painting", "",
               "A light that is nowhere yet: it gets a row, and shines where you paint it.",
               [&studio] { addPaintedLight(studio); }, hasLights});
  actions.add({"brush.smaller", "Smaller brush", "[", "Also Ctrl and the wheel.",
               [&studio] { setBrushRadius(studio, brushRadius(studio) / kSizeStep); }, painting});
  actions.add({"brush.larger", "Larger brush", "]", "Also Ctrl and the wheel.",
               [&studio] { setBrushRadius(studio, brushRadius(studio) * kSizeStep); }, painting});
  actions.add({"brush.softer", "Softer rim of the brush", "Shift+[", "Its light falls off from further in.",
               [&brush] { brush.hardness = std::max(0.0F, brush.hardness - kHardnessStep); }, painting});
  actions.add({"brush.harder", "Harder rim of the brush", "Shift+]", "Its light ends more sharply.",
               [&brush] { brush.hardness = std::min(1.0F, brush.hardness + kHardnessStep); }, painting});
  actions.add({"brush.erase", "Take paint off", "X", "The brush takes off what it painted; again: it paints.",
               [&brush] { brush.erase = !brush.erase; }, painting, [&brush] { return brush.erase; }});
  for (int tenth = 1; tenth <= 10; ++tenth)
    actions.add({fmt::format("brush.opacity_{}", 10 * tenth), fmt::format("Brush at {} %", 10 * tenth),
                 std::to_string(tenth % 10), "How much a stroke can build up to.",
                 [&brush, tenth] { brush.opacity = 0.1F * static_cast<float>(tenth); }, painting});
}

}  // namespace swaplight
