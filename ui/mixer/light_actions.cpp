#include "ui/mixer/mixer_actions.h"

#include <fmt/core.h>

#include "core/base/error.h"
#include "core/lamp/gel.h"
#include "core/relight/rig_edit.h"
#include "ui/control/light_edit.h"
#include "ui/mixer/light_menu.h"

namespace swaplight {
namespace {

void askForGels(LightsContext& studio, FileChooser& chooser) {
  chooser.ask({"Import a table of gels",
               "Import",
               {".csv"},
               false,
               "",
               {},
               [&studio](const std::filesystem::path& file) {
                 try {
                   const size_t count = importGels(file);
                   studio.messages.info(fmt::format("{} gels from {}", count, file.filename().string()));
                 } catch (const InputError& error) {
                   studio.messages.error(error.what());
                 }
               }});
}

}  // namespace

void addLightActions(ActionTable& actions, LightsContext& studio, FileChooser& chooser) {
  const auto hasLights = [&studio] { return !studio.document().rig.lights.empty(); };
  const auto light = [&studio] { return shownLight(studio); };
  actions.add(
      {"light.solo", "Solo", "S", "Solo the selected light.",
       [&studio, light] { toggleSolo(studio, light(), false); }, hasLights,
       [&studio, light, hasLights] { return hasLights() && studio.document().rig.lights[light()].solo; }});
  actions.add({"light.solo_alone", "Solo alone", "Alt+S",
               "Solo the selected light and clear every other solo.",
               [&studio, light] { toggleSolo(studio, light(), true); }, hasLights});
  actions.add(
      {"light.mute", "Mute", "M", "Mute the selected light.",
       [&studio, light] {
         const bool mute = !studio.document().rig.lights[light()].mute;
         editLights(studio, light(), mute ? "mute" : "unmute",
                    [mute](LightSetting& setting) { setting.mute = mute; });
       },
       hasLights,
       [&studio, light, hasLights] { return hasLights() && studio.document().rig.lights[light()].mute; }});
  actions.add({"light.rename", "Rename", "F2", "Rename the selected light in the studio.",
               [&studio, light] { beginRename(studio, light()); }, hasLights});
  actions.add({"light.copy", "Copy light", "Ctrl+C", "Copy the selected light's colour and level.",
               [&studio, light] { studio.mixer.copied = studio.document().rig.lights[light()]; }, hasLights});
  actions.add({"light.paste", "Paste light", "Ctrl+V",
               "Paste the copied colour and level onto the selected lights.",
               [&studio, light] {
                 editLights(studio, light(), "paste", [&studio](LightSetting& setting) {
                   setting = pastedLight(setting, *studio.mixer.copied);
                 });
               },
               [&studio, hasLights] { return hasLights() && studio.mixer.copied; }});
  actions.add({"light.reset", "Reset light", "",
               "Reset colour and level of the selected lights: on, unit white, 0 stops.",
               [&studio, light] {
                 editLights(studio, light(), "reset",
                            [](LightSetting& setting) { setting = resetLight(setting); });
               },
               hasLights});
  actions.add({"mixer.as_captured", "As captured", "", "Set every light as it was in the first photograph.",
               [&studio] {
                 editRig(
                     studio, "As captured",
                     rigOfShot(*studio.colors.config(), studio.document().rig, studio.set()->solved(), 0));
               },
               [&studio] { return studio.set() && !studio.set()->solved().capture.shots.empty(); }});
  actions.add({"mixer.all_white", "Reset all lights", "", "Turn every light on at unit white, 0 stops.",
               [&studio] { editRig(studio, "Reset all lights", unitWhiteRig(studio.document().rig)); },
               hasLights});
  actions.add({"mixer.all_off", "All off", "", "Turn every light off.",
               [&studio] { editRig(studio, "All off", allOffRig(studio.document().rig)); }, hasLights});
  actions.add({"mixer.import_gels", "Import gels …", "",
               "Add a table of gels to the list (CSV: brand, number, name, x, y, T).",
               [&studio, &chooser] { askForGels(studio, chooser); }});
}

}  // namespace swaplight
