#include "ui/shell/studio_window.h"

namespace swaplight {

void StudioWindow::addWindowActions() {
  const auto panel = [&](const char* id, const char* name, const char* keys, const char* tip, bool* open) {
    m_actions.add({id, name, keys, tip, [open] { *open = !*open; }, {}, [open] { return *open; }});
  };
  for (const PanelInfo& one : m_panels) panel(one.id, one.name, one.keys, one.tooltip, &(m_layout.*one.open));
  panel("view.hide_panels", "Only the picture", "Tab", "Hide everything but the viewer; again: show it.",
        &m_layout.hidden);
  panel("edit.history", "History", "Ctrl+H", "Every step; a click goes back to it.", &m_historyOpen);
  panel("help.about", "About Swaplight", "", "Version, and who computes the picture.", &m_aboutOpen);
  m_actions.add({"view.full_screen", "Full screen", "F11", "The whole monitor; again: a window.",
                 [this] { m_window.toggleFullScreen(); }});
  m_actions.add({"window.reset", "Panels as in the beginning", "", "Every panel open at its first size.",
                 [this] { m_layout = {}; }});
  m_actions.add({"view.look", "Put the tool away", "Escape", "The mouse moves the picture again.",
                 [this] { m_tool = Tool::Look; }, [this] { return m_tool != Tool::Look; }});
  m_actions.add({"help.keys",
                 "Keys",
                 "? F1",
                 "Every action with its keys, and how to change them.",
                 [this] { m_keys.toggle(); },
                 {},
                 [this] { return m_keys.isOpen(); }});
  m_actions.add({"help.palette", "Find an action \u2026", "Ctrl+Shift+P",
                 "Every action by a few letters of its name.", [this] { m_palette.open(); }});
  m_actions.add({"scopes.region", "Region of the scopes", "Shift+S",
                 "Draw a rectangle in the picture that the scopes look at; again: the whole frame.",
                 [this] {
                   const bool drawing = m_tool == Tool::Region;
                   m_tool = drawing ? Tool::Look : Tool::Region;
                   m_layout.scopeOptions.of = drawing ? ScopeOptions::Of::Frame : ScopeOptions::Of::Region;
                   if (drawing) m_viewer.region.reset();
                   m_layout.scopes = true;
                 },
                 [this] { return m_session.set() != nullptr; }, [this] { return m_tool == Tool::Region; }});
}

}  // namespace swaplight
