#include "ui/shell/studio_window.h"
#include "ui/viewer/viewer_mouse.h"

namespace swaplight {

void StudioWindow::addWindowActions() {
  const auto panel = [&](const char* id, const char* name, const char* keys, const char* tip, bool* open) {
    m_actions.add({id, name, keys, tip, [open] { *open = !*open; }, {}, [open] { return *open; }});
  };
  for (const PanelInfo& one : m_panels) panel(one.id, one.name, one.keys, one.tooltip, &(m_layout.*one.open));
  panel("view.hide_panels", "Hide panels", "Tab", "Hide everything but the viewer. Press again to show it.",
        &m_layout.hidden);
  panel("edit.history", "History", "Ctrl+H", "Every step. Click one to go back to it.", &m_historyOpen);
  panel("help.about", "About Swaplight", "", "Version and render engine.", &m_aboutOpen);
  m_actions.add({"view.full_screen", "Full screen", "F11", "Use the whole monitor. Press again to leave.",
                 [this] { m_window.toggleFullScreen(); }});
  m_actions.add({"window.reset", "Reset panel layout", "", "Open every panel at its default size.",
                 [this] { m_layout = {}; }});
  m_actions.add({"view.look", "Hand tool", "Escape", "Leave the current tool; dragging pans the picture.",
                 [this] { m_tool = nullptr; }, [this] { return m_tool != nullptr; }});
  m_actions.add({"help.keys",
                 "Keyboard shortcuts",
                 "? F1",
                 "Every action with its shortcut. Shortcuts can be changed.",
                 [this] { m_keys.toggle(); },
                 {},
                 [this] { return m_keys.isOpen(); }});
  m_actions.add({"help.tour", "Take the tour", "",
                 "Five steps through the studio, over the open set or a sample; Escape ends it.",
                 [this] { startTour(); },
                 [this] { return m_session.set() || std::filesystem::exists(m_tourSample); }});
  m_actions.add({"help.palette", "Find an action \u2026", "Ctrl+Shift+P",
                 "Find any action by a few letters of its name.", [this] { m_palette.open(); }});
  m_actions.add({kScopeRegion.id, kScopeRegion.name, kScopeRegion.keys, kScopeRegion.tooltip,
                 [this] {
                   const bool drawing = m_tool == &kScopeRegion;
                   m_tool = drawing ? nullptr : &kScopeRegion;
                   m_layout.scopeOptions.of = drawing ? ScopeOptions::Of::Frame : ScopeOptions::Of::Region;
                   if (drawing) m_viewer.region.reset();
                   m_layout.scopes = true;
                 },
                 [this] { return m_session.set() != nullptr; }, [this] { return m_tool == &kScopeRegion; }});
}

}  // namespace swaplight
