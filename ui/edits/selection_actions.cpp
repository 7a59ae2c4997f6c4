#include "ui/shell/studio_window.h"
#include "ui/tools/selection_tool.h"

namespace swaplight {

void StudioWindow::addSelectionActions() {
  const auto hasLights = [this] { return m_session.set() && !m_editor.document().rig.lights.empty(); };
  const auto selected = [this] { return m_session.set() && !m_editor.document().selection.empty(); };
  m_actions.add({"select.take", "Select a part of the picture", "Shift+L",
                 "Select by lasso, rectangle, ellipse, likeness or shadow: edits then stay inside of it.",
                 [this] { takeEditTool(Tool::Select); }, hasLights,
                 [this] { return m_tool == Tool::Select; }});
  m_actions.add({"stencil.take", "Stencils and gradients", "Shift+T",
                 "Lay light on through words, shapes, a picture, or as a gradient, by dragging.",
                 [this] { takeEditTool(Tool::Stencil); }, hasLights,
                 [this] { return m_tool == Tool::Stencil; }});
  m_actions.add({"stencil.choose_picture", "Picture as a stencil \u2026", "",
                 "The picture whose brightness lets the light through.", [this] { askForStencilPicture(); },
                 hasLights});
  m_actions.add({"select.clear", "Select nothing", "Ctrl+D", "Edits reach everywhere again.",
                 [this] { changeSelection(m_context, "Select nothing", {}); }, selected});
  m_actions.add({"select.invert", "Invert the selection", "Ctrl+Shift+I", "Select what was not selected.",
                 [this] {
                   changeSelection(m_context, "Invert the selection",
                                   invertedSelection(m_editor.document().selection));
                 },
                 selected});
}

}  // namespace swaplight
