#include "ui/edits/edits_actions.h"

#include <fmt/core.h>

#include <algorithm>

#include "ui/tools/brush_tool.h"

namespace swaplight {
namespace {

constexpr float kSizeStep = 1.25F;
constexpr float kHardnessStep = 0.1F;

}  // namespace

void addBrushActions(ActionTable& actions, EditingContext& studio) {
  const auto hasLights = [&studio] { return studio.hasLights(); };
  const auto painting = [&studio] { return studio.tool == &kBrush && studio.hasLights(); };
  BrushState& brush = studio.editing.brush;
  actions.add({"edit.cancel_drag", "Cancel drag", "Escape",
               "While dragging: cancel the stroke, gobo, handle or lasso.",
               [&studio] {
                 studio.editor.cancel();
                 studio.editing.endDrags();
               },
               [&studio] { return studio.editing.dragging(); }});
  actions.add({"brush.new_light", "New light by painting", "",
               "Adds a light that shines only where you paint it.", [&studio] { addPaintedLight(studio); },
               hasLights});
  actions.add({"brush.smaller", "Smaller brush", "[", "Also Ctrl and the wheel.",
               [&studio] { setBrushRadius(studio, brushRadius(studio) / kSizeStep); }, painting});
  actions.add({"brush.larger", "Larger brush", "]", "Also Ctrl and the wheel.",
               [&studio] { setBrushRadius(studio, brushRadius(studio) * kSizeStep); }, painting});
  actions.add({"brush.softer", "Softer brush", "Shift+[", "Lower the brush's hardness.",
               [&brush] { brush.hardness = std::max(0.0F, brush.hardness - kHardnessStep); }, painting});
  actions.add({"brush.harder", "Harder brush", "Shift+]", "Raise the brush's hardness.",
               [&brush] { brush.hardness = std::min(1.0F, brush.hardness + kHardnessStep); }, painting});
  actions.add({"brush.erase", "Erase", "X", "Erase what the brush has painted. Press again to paint.",
               [&brush] { brush.erase = !brush.erase; }, painting, [&brush] { return brush.erase; }});
  actions.add({"brush.edges", "Follow edges", "Shift+X",
               "Paint only what is like the surface under the middle of the brush.",
               [&brush] { brush.edges = !brush.edges; }, painting, [&brush] { return brush.edges; }});
  for (int tenth = 1; tenth <= 10; ++tenth)
    actions.add({fmt::format("brush.opacity_{}", 10 * tenth), fmt::format("Brush at {} %", 10 * tenth),
                 std::to_string(tenth % 10), "The most a stroke can build up to.",
                 [&brush, tenth] { brush.opacity = 0.1F * static_cast<float>(tenth); }, painting});
}

}  // namespace swaplight
