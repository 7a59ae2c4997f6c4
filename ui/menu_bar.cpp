#include "ui/menu_bar.h"

#include <imgui.h>

#include <vector>

#include "ui/layout_probe.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace swaplight {
namespace {

struct Menu {
  const char* name;
  std::vector<const char*> items;  ///< action ids; "-" is a line; "recent" the list of recent files
};

const std::vector<Menu>& menus() {
  static const std::vector<Menu> all = {
      {"File",
       {"file.open", "recent", "-", "file.save", "file.save_as", "-", "file.export", "-", "file.close",
        "file.quit"}},
      {"Edit", {"edit.undo", "edit.redo"}},
      {"View",
       {"view.fit", "view.one_to_one", "view.zoom_in", "view.zoom_out", "-", "view.mixer", "view.hide_panels",
        "view.full_screen"}},
  };
  return all;
}

void recentMenu(StudioContext& studio) {
  const std::vector<std::filesystem::path>& files = studio.session.recent().files();
  if (!ImGui::BeginMenu("Open recent", !files.empty())) return;
  std::filesystem::path chosen;
  for (const std::filesystem::path& file : files)
    if (ImGui::MenuItem(file.c_str())) chosen = file;
  if (!chosen.empty()) studio.session.open(chosen);
  ImGui::EndMenu();
}

}  // namespace

void actionMenuItem(const ActionTable& actions, const std::string& id) {
  const Action* action = actions.find(id);
  if (!action) return;
  if (ImGui::MenuItem(action->name.c_str(), action->firstKeys().c_str(), action->isChecked(),
                      action->isEnabled()))
    action->run();
  markItem("menu." + id);
  tooltip(action->tooltip.c_str());
}

bool actionButton(const ActionTable& actions, const std::string& id, const char* icon, float side) {
  const Action* action = actions.find(id);
  if (!action) return false;
  ImGui::BeginDisabled(!action->isEnabled());
  ImGui::PushID(id.c_str());
  const std::string keys = action->firstKeys();
  const std::string tip = action->name + (keys.empty() ? "" : "  (" + keys + ")") + "\n" + action->tooltip;
  const bool clicked = toggleButton(icon, action->isChecked(), kAccent, side, tip.c_str());
  markItem("button." + id);
  ImGui::PopID();
  ImGui::EndDisabled();
  if (clicked) action->run();
  return clicked;
}

void drawMenuBar(StudioContext& studio) {
  if (!ImGui::BeginMenuBar()) return;
  for (const Menu& menu : menus()) {
    const bool open = ImGui::BeginMenu(menu.name);
    markItem(std::string("menu.") + menu.name);
    if (!open) continue;
    for (const std::string item : menu.items) {
      if (item == "-")
        ImGui::Separator();
      else if (item == "recent")
        recentMenu(studio);
      else
        actionMenuItem(studio.actions, item);
    }
    ImGui::EndMenu();
  }
  ImGui::EndMenuBar();
}

}  // namespace swaplight
