#include "ui/control/look_edit.h"
#include "ui/shell/studio_window.h"

namespace swaplight {

void StudioWindow::addLookActions() {
  m_actions.add({"looks.keep", "Keep the lighting as a look", "Shift+K",
                 "Put the lighting of now into the gallery.",
                 [this] {
                   keepLook(m_context);
                   m_layout.gallery = true;
                 },
                 [this] { return m_session.set() && !m_editor.document().rig.lights.empty(); }});
}

}  // namespace swaplight
