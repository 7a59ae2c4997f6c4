#include "ui/shell/menu_bar.h"

#include <imgui.h>

#include <vector>

#include "ui/kit/action_widgets.h"
#include "ui/kit/layout_probe.h"
#include "ui/mixer/light_menu.h"
#include "ui/viewer/subject_menu.h"
#include "ui/viewer/viewer_bar.h"

namespace swaplight {
namespace {

struct Menu {
  const char* name;
  std::vector<const char*> items;  ///< action ids; "-" is a line; the others are menus of their own
};

const std::vector<Menu>& menus() {
  static const std::vector<Menu> all = {
      {"File",
       {"file.new", "file.open", "recent", "file.use_on_set", "-", "file.save", "file.save_as", "-",
        "file.export", "-", "file.close", "file.quit"}},
      {"Edit",
       {"edit.undo", "edit.redo", "edit.history", "-", "brush.take", "stencil.take", "brush.new_light", "-",
        "select.take", "select.invert", "select.clear", "-", "view.shadows", "shadows.mark_shadow",
        "shadows.mark_lit", "shadows.clear_marks", "view.edits"}},
      {"Lights",
       {"light.solo",
        "light.solo_alone",
        "light.mute",
        "desk.type",
        "-",
        "light.rename",
        "light.copy",
        "light.paste",
        "light.reset",
        "-",
        "light.neutral",
        "light.match",
        "-",
        "light.neutralize",
        "mixer.neutralize_all",
        "mixer.neutralize_others",
        "white_point",
        "-",
        "mixer.read_photograph",
        "mixer.as_captured",
        "mixer.all_white",
        "mixer.all_off",
        "-",
        "view.three_point",
        "looks.keep",
        "looks.keep_version",
        "cues.record",
        "cues.go",
        "cues.back",
        "-",
        "mixer.import_gels",
        "file.chart"}},
      {"View",
       {"view.fit",
        "view.one_to_one",
        "view.zoom_in",
        "view.zoom_out",
        "-",
        "subject",
        "view.photograph",
        "view.next_photograph",
        "-",
        "channel.all",
        "channel.red",
        "channel.green",
        "channel.blue",
        "channel.luminance",
        "-",
        "view.false_color",
        "view.zebra",
        "view.pools",
        "view.probe",
        "view.probe_size",
        "view.expose",
        "view.neutral",
        "display",
        "-",
        "camera_look.load",
        "camera_look.save",
        "camera_look.remove",
        "-",
        "grade.switch",
        "grade.load",
        "grade.save",
        "grade.reset"}},
      {"Compare",
       {"compare.off", "compare.wipe", "compare.split", "compare.difference", "compare.toggle", "-",
        "compare.keep", "side_b", "compare.center_line"}},
      {"Window",
       {"panels", "view.shadows", "scopes.region", "-", "view.hide_panels", "view.full_screen",
        "window.reset"}},
      {"Help", {"help.tour", "help.palette", "help.keys", "help.about"}},
  };
  return all;
}

template <typename Lines>
void submenu(const char* name, bool enabled, const Lines& lines) {
  if (!ImGui::BeginMenu(name, enabled)) return;
  lines();
  ImGui::EndMenu();
}

void recentMenu(SessionController& session) {
  const std::vector<std::filesystem::path>& files = session.recent().files();
  if (!ImGui::BeginMenu("Open recent", !files.empty())) return;
  std::filesystem::path chosen;
  for (const std::filesystem::path& file : files)
    if (ImGui::MenuItem(file.c_str())) chosen = file;
  if (!chosen.empty()) session.open(chosen);
  ImGui::EndMenu();
}

}  // namespace

void drawMenuBar(ViewerContext& studio, const std::vector<PanelInfo>& panels) {
  if (!ImGui::BeginMenuBar()) return;
  for (const Menu& menu : menus()) {
    const bool open = ImGui::BeginMenu(menu.name);
    markItem({"menu.", menu.name});
    if (!open) continue;
    for (const std::string item : menu.items) {
      if (item == "-")
        ImGui::Separator();
      else if (item == "recent")
        recentMenu(studio.session);
      else if (item == "subject")
        submenu("Show", studio.set(), [&] { drawSubjectMenu(studio, false); });
      else if (item == "side_b")
        submenu("B", studio.set(), [&] { drawSubjectMenu(studio, true); });
      else if (item == "display")
        submenu("Display and view", studio.set(), [&] { drawDisplayMenu(studio); });
      else if (item == "white_point")
        drawWhiteMenu(studio.actions);
      else if (item == "panels")
        for (const PanelInfo& panel : panels) actionMenuItem(studio.actions, panel.id);
      else
        actionMenuItem(studio.actions, item);
    }
    ImGui::EndMenu();
  }
  ImGui::EndMenuBar();
}

}  // namespace swaplight
