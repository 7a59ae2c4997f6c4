#include "ui/mixer/light_menu.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "core/balance/white_point.h"
#include "core/relight/rig_edit.h"
#include "ui/control/light_edit.h"
#include "ui/kit/action_widgets.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

constexpr Role kRoles[] = {Role::Key,    Role::Fill,       Role::Back, Role::Practical,
                           Role::Kicker, Role::Background, Role::Other};

bool hasGroup(const Rig& rig, const std::string& name) {
  return std::any_of(rig.groups.begin(), rig.groups.end(),
                     [&](const LightGroup& g) { return g.name == name; });
}

/// Groups that no light is in any more vanish.
Rig withoutEmptyGroups(Rig rig) {
  std::erase_if(rig.groups, [&](const LightGroup& group) {
    return std::none_of(rig.lights.begin(), rig.lights.end(),
                        [&](const LightSetting& light) { return light.group == group.name; });
  });
  return rig;
}

void putIntoGroup(LightsContext& studio, size_t light, const std::string& name) {
  Rig rig = studio.document().rig;
  if (!name.empty() && !hasGroup(rig, name)) rig.groups.push_back({name, 0, true});
  for (const size_t i : lightsFor(studio, light)) rig.lights[i].group = name;
  editRig(studio, name.empty() ? "ungroup" : "group " + name, withoutEmptyGroups(std::move(rig)));
}

void groupMenu(LightsContext& studio, size_t light) {
  const bool open = ImGui::BeginMenu("Group");
  markItem("light_menu.group");
  if (!open) return;
  const Rig& rig = studio.document().rig;
  std::string chosen;
  bool any = false;
  if (ImGui::MenuItem("none", nullptr, rig.lights[light].group.empty())) any = true;
  for (const LightGroup& group : rig.groups)
    if (ImGui::MenuItem(group.name.c_str(), nullptr, rig.lights[light].group == group.name)) {
      chosen = group.name;
      any = true;
    }
  ImGui::Separator();
  if (ImGui::InputTextWithHint("##new group", "New group", &studio.mixer.groupName,
                               ImGuiInputTextFlags_EnterReturnsTrue) &&
      !studio.mixer.groupName.empty()) {
    chosen = std::exchange(studio.mixer.groupName, "");
    any = true;
    ImGui::CloseCurrentPopup();
  }
  markItem("light_menu.new_group");
  ImGui::EndMenu();
  if (any) putIntoGroup(studio, light, chosen);
}

void roleMenu(LightsContext& studio, size_t light) {
  if (!ImGui::BeginMenu("Role")) return;
  for (const Role role : kRoles)
    if (ImGui::MenuItem(roleName(role).c_str(), nullptr, studio.document().rig.lights[light].role == role))
      editLights(studio, light, "role " + roleName(role),
                 [&](LightSetting& setting) { setting.role = role; });
  ImGui::EndMenu();
}

void shotMenu(LightsContext& studio) {
  const OpenSet* set = studio.set();
  if (!set || set->solved().capture.shots.empty() || !ImGui::BeginMenu("As captured")) return;
  for (size_t shot = 0; shot < set->solved().capture.shots.size(); ++shot) {
    const std::string name = fmt::format("Shot {}", shot + 1);
    if (ImGui::MenuItem(name.c_str()))
      editRig(studio, "As captured: " + name,
              rigOfShot(*studio.colors.config(), studio.document().rig, set->solved(), shot));
  }
  ImGui::EndMenu();
}

void unitMenu(LightsContext& studio) {
  if (!ImGui::BeginMenu("Show levels in")) return;
  using Unit = LevelUnit;
  for (const auto& [unit, name] :
       {std::pair{Unit::Stops, "stops"}, {Unit::Percent, "percent"}, {Unit::Multiplier, "multiplier"}})
    if (ImGui::MenuItem(name, nullptr, studio.mixer.unit == unit)) studio.mixer.unit = unit;
  ImGui::EndMenu();
}

}  // namespace

void drawWhiteMenu(const ActionTable& actions) {
  const bool open = ImGui::BeginMenu("White point");
  markItem("menu.white_point");
  if (!open) tooltip("The white that neutralised lamps have.");
  if (!open) return;
  for (const NamedWhite& named : namedWhites()) actionMenuItem(actions, std::string("white.") + named.name);
  ImGui::EndMenu();
}

void beginRename(LightsContext& studio, size_t light) {
  studio.mixer.renaming = static_cast<int>(light);
  studio.mixer.name = studio.document().rig.lights[light].title();
  studio.mixer.nameFocused = false;
}

Rig withoutGroup(Rig rig, const std::string& name) {
  for (const LightGroup& group : rig.groups) {
    if (group.name != name) continue;
    for (LightSetting& light : rig.lights) {
      if (light.group != name) continue;
      light.group.clear();
      light.stops += group.stops;
      light.on = light.on && group.on;
    }
  }
  return withoutEmptyGroups(std::move(rig));
}

void drawLightMenu(LightsContext& studio, size_t light) {
  actionMenuItem(studio.actions, "light.rename");
  roleMenu(studio, light);
  groupMenu(studio, light);
  const bool locked = studio.document().rig.lights[light].ratioLock;
  if (ImGui::MenuItem("Link", nullptr, locked))
    editLights(studio, light, locked ? "unlink" : "link",
               [&](LightSetting& setting) { setting.ratioLock = !locked; });
  markItem("light_menu.link");
  const bool on = studio.document().rig.lights[light].on;
  if (ImGui::MenuItem("Off", nullptr, !on))
    editLights(studio, light, on ? "off" : "on", [&](LightSetting& setting) { setting.on = !on; });
  markItem("light_menu.off");
  tooltip(
      "A light that was photographed stays in the set; off, it gives nothing to the picture or to any "
      "export.");
  ImGui::Separator();
  for (const char* id : {"light.copy", "light.paste", "light.reset"}) actionMenuItem(studio.actions, id);
  ImGui::Separator();
  for (const char* id : {"light.neutralize", "light.neutral", "light.match"})
    actionMenuItem(studio.actions, id);
}

void drawMixerMenu(LightsContext& studio) {
  shotMenu(studio);
  for (const char* id : {"mixer.all_white", "mixer.all_off"}) actionMenuItem(studio.actions, id);
  actionMenuItem(studio.actions, "mixer.read_photograph");
  ImGui::Separator();
  for (const char* id : {"mixer.neutralize_all", "mixer.neutralize_others"})
    actionMenuItem(studio.actions, id);
  drawWhiteMenu(studio.actions);
  ImGui::Separator();
  unitMenu(studio);
  actionMenuItem(studio.actions, "mixer.import_gels");
}

}  // namespace swaplight
