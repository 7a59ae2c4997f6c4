#include <fmt/core.h>

#include <algorithm>

#include "ui/shell/studio_window.h"
#include "ui/tools/brush_tool.h"

namespace swaplight {
namespace {

constexpr float kSizeStep = 1.25F;
constexpr float kHardnessStep = 0.1F;

}  // namespace

void StudioWindow::takeEditTool(Tool tool) {
  m_tool = m_tool == tool ? Tool::Look : tool;
  if (m_tool != tool) return;
  m_layout.edits = true;
  m_edits.prepare(m_context);
}

void StudioWindow::addBrushActions() {
  const auto hasLights = [this] { return m_session.set() && !m_editor.document().rig.lights.empty(); };
  const auto painting = [this, hasLights] { return m_tool == Tool::Brush && hasLights(); };
  BrushState& brush = m_editing.brush;
  m_actions.add({"edit.cancel_drag", "Take the drag back", "Escape",
                 "While the button is held: the stroke, stencil, handle or lasso as if it had never begun.",
                 [this] {
                   m_editor.cancel();
                   m_editing.endDrags();
                 },
                 [this] { return m_editing.dragging(); }});
  m_actions.add(
      {"brush.take", "Paint with light", "Shift+B",
       "Paint on the picture with the chosen light: more of it, less, softer; again: put the brush away.",
       [this] { takeEditTool(Tool::Brush); }, hasLights, [this] { return m_tool == Tool::Brush; }});
  m_actions.add({"brush.new_light", "New light by painting", "",
                 "A light that is nowhere yet: it gets a row, and shines where you paint it.",
                 [this] { addPaintedLight(m_context); }, hasLights});
  m_actions.add({"brush.smaller", "Smaller brush", "[", "Also Ctrl and the wheel.",
                 [this] { setBrushRadius(m_context, brushRadius(m_context) / kSizeStep); }, painting});
  m_actions.add({"brush.larger", "Larger brush", "]", "Also Ctrl and the wheel.",
                 [this] { setBrushRadius(m_context, brushRadius(m_context) * kSizeStep); }, painting});
  m_actions.add({"brush.softer", "Softer rim of the brush", "Shift+[", "Its light falls off from further in.",
                 [&brush] { brush.hardness = std::max(0.0F, brush.hardness - kHardnessStep); }, painting});
  m_actions.add({"brush.harder", "Harder rim of the brush", "Shift+]", "Its light ends more sharply.",
                 [&brush] { brush.hardness = std::min(1.0F, brush.hardness + kHardnessStep); }, painting});
  m_actions.add({"brush.erase", "Take paint off", "X",
                 "The brush takes off what it painted; again: it paints.",
                 [&brush] { brush.erase = !brush.erase; }, painting, [&brush] { return brush.erase; }});
  for (int tenth = 1; tenth <= 10; ++tenth)
    m_actions.add({fmt::format("brush.opacity_{}", 10 * tenth), fmt::format("Brush at {} %", 10 * tenth),
                   std::to_string(tenth % 10), "How much a stroke can build up to.",
                   [&brush, tenth] { brush.opacity = 0.1F * static_cast<float>(tenth); }, painting});
}

}  // namespace swaplight
