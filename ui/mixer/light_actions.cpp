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
  const auto hasSet = [&studio] { return studio.set() != nullptr; };
  const auto light = [&studio] { return shownLight(studio); };
  actions.add(
      {"light.solo", "Solo", "S", "Only the chosen light.",
       [&studio, light] { toggleSolo(studio, light(), false); }, hasLights,
       [&studio, light, hasLights] { return hasLights() && studio.document().rig.lights[light()].solo; }});
  actions.add({"light.solo_alone", "Solo alone", "Alt+S", "Only the chosen light, whatever else was solo.",
               [&studio, light] { toggleSolo(studio, light(), true); }, hasLights});
  actions.add(
      {"light.mute", "Mute", "M", "Not the chosen light.",
       [&studio, light] {
         const bool mute = !studio.document().rig.lights[light()].mute;
         editLights(studio, light(), mute ? "mute" : "unmute",
                    [mute](LightSetting& setting) { setting.mute = mute; });
       },
       hasLights,
       [&studio, light, hasLights] { return hasLights() && studio.document().rig.lights[light()].mute; }});
  actions.add({"light.rename", "Rename", "F2", "Give the chosen light another name in the studio.",
               [&studio, light] { beginRename(studio, light()); }, hasLights});
  actions.add({"light.copy", "Copy light", "Ctrl+C", "Remember the chosen light's colour and intensity.",
               [&studio, light] { studio.mixer.copied = studio.document().rig.lights[light()]; }, hasLights});
  actions.add({"light.paste", "Paste light", "Ctrl+V",
               "Give the chosen lights the remembered colour and intensity.",
               [&studio, light] {
                 editLights(studio, light(), "paste", [&studio](LightSetting& setting) {
                   setting = pastedLight(setting, *studio.mixer.copied);
                 });
               },
               [&studio, hasLights] { return hasLights() && studio.mixer.copied; }});
  actions.add({"light.reset", "Reset light", "", "The chosen lights white, without stops, on.",
               [&studio, light] {
                 editLights(studio, light(), "reset",
                            [](LightSetting& setting) { setting = resetLight(setting); });
               },
               hasLights});
  actions.add({"light.neutral", "Make a pixel neutral", "N",
               "Click into the picture: the chosen lights take the colour in which that pixel is grey.",
               [&studio] { studio.tool = studio.tool == Tool::Neutral ? Tool::Look : Tool::Neutral; }, hasSet,
               [&studio] { return studio.tool == Tool::Neutral; }});
  actions.add({"light.match", "Match a pixel's colour", "",
               "Click into the picture: the chosen lights take that pixel's colour. Also Alt + click.",
               [&studio] { studio.tool = studio.tool == Tool::Match ? Tool::Look : Tool::Match; }, hasSet,
               [&studio] { return studio.tool == Tool::Match; }});
  actions.add({"mixer.as_captured", "As captured", "", "Every light as in the first shot.",
               [&studio] {
                 editRig(
                     studio, "As captured",
                     rigOfShot(*studio.colors.config(), studio.document().rig, studio.set()->solved(), 0));
               },
               [&studio] { return studio.set() && !studio.set()->solved().capture.shots.empty(); }});
  actions.add({"mixer.all_white", "All white", "", "Every light on, white, without stops.",
               [&studio] { editRig(studio, "All white", allWhiteRig(studio.document().rig)); }, hasLights});
  actions.add({"mixer.all_off", "All off", "", "Every light off.",
               [&studio] { editRig(studio, "All off", allOffRig(studio.document().rig)); }, hasLights});
  actions.add({"mixer.import_gels", "Import gels …", "",
               "Take a table of gels (CSV: brand, number, name, x, y, T) into the list.",
               [&studio, &chooser] { askForGels(studio, chooser); }});
}

}  // namespace swaplight
