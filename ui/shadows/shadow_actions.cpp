#include "ui/control/shadow_edit.h"
#include "ui/shell/studio_window.h"

namespace swaplight {

void StudioWindow::addShadowActions() {
  m_actions.add({"view.shadows", "Shadows and \u03b2", "F3",
                 "Each light's shadows: where they begin, their outlines, and what to do about them.",
                 [this] {
                   m_layout.shadows = !shadowsShown(m_context);
                   if (!m_layout.shadows) return;
                   m_layout.edits = true;
                   m_tool = Tool::Look;
                 },
                 [this] { return m_session.set() && !m_editor.document().rig.lights.empty(); },
                 [this] { return shadowsShown(m_context); }});
  m_actions.add({"shadows.outlines", "Outlines of shadows", "Shift+F3",
                 "Draw the borders of the chosen light's shadows over the picture.",
                 [this] { m_editing.shadow.outlines = !m_editing.shadow.outlines; },
                 [this] { return shadowsShown(m_context); }, [this] { return m_editing.shadow.outlines; }});
  m_actions.add(
      {"shadows.choose_all", "All shadows of the light", "Escape",
       "What is done to shadows is done to all of the light's, not to the one that was clicked.",
       [this] { m_shadows.chooseAll(m_context); },
       [this] { return shadowsShown(m_context) && m_editing.shadow.chosen && m_tool == Tool::Look; }});
}

}  // namespace swaplight
