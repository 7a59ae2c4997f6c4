#include "core/base/error.h"
#include "core/lamp/gel.h"
#include "core/relight/rig_edit.h"
#include "ui/control/light_edit.h"
#include "ui/mixer/light_menu.h"
#include "ui/shell/studio_window.h"

namespace swaplight {

void StudioWindow::addLightActions() {
  const auto hasLights = [this] { return !m_editor.document().rig.lights.empty(); };
  const auto hasSet = [this] { return m_session.set() != nullptr; };
  const auto light = [this] { return shownLight(m_context); };
  m_actions.add(
      {"light.solo", "Solo", "S", "Only the chosen light.",
       [this, light] { toggleSolo(m_context, light(), false); }, hasLights,
       [this, light, hasLights] { return hasLights() && m_editor.document().rig.lights[light()].solo; }});
  m_actions.add({"light.solo_alone", "Solo alone", "Alt+S", "Only the chosen light, whatever else was solo.",
                 [this, light] { toggleSolo(m_context, light(), true); }, hasLights});
  m_actions.add(
      {"light.mute", "Mute", "M", "Not the chosen light.",
       [this, light] {
         const bool mute = !m_editor.document().rig.lights[light()].mute;
         editLights(m_context, light(), mute ? "mute" : "unmute",
                    [mute](LightSetting& setting) { setting.mute = mute; });
       },
       hasLights,
       [this, light, hasLights] { return hasLights() && m_editor.document().rig.lights[light()].mute; }});
  m_actions.add({"light.rename", "Rename", "F2", "Give the chosen light another name in the studio.",
                 [this, light] { beginRename(m_context, light()); }, hasLights});
  m_actions.add({"light.copy", "Copy light", "Ctrl+C", "Remember the chosen light's colour and intensity.",
                 [this, light] { m_mixer.copied = m_editor.document().rig.lights[light()]; }, hasLights});
  m_actions.add(
      {"light.paste", "Paste light", "Ctrl+V", "Give the chosen lights the remembered colour and intensity.",
       [this, light] {
         editLights(m_context, light(), "paste",
                    [this](LightSetting& setting) { setting = pastedLight(setting, *m_mixer.copied); });
       },
       [this, hasLights] { return hasLights() && m_mixer.copied; }});
  m_actions.add({"light.reset", "Reset light", "", "The chosen lights white, without stops, on.",
                 [this, light] {
                   editLights(m_context, light(), "reset",
                              [](LightSetting& setting) { setting = resetLight(setting); });
                 },
                 hasLights});
  m_actions.add({"light.neutral", "Make a pixel neutral", "N",
                 "Click into the picture: the chosen lights take the colour in which that pixel is grey.",
                 [this] { m_tool = m_tool == Tool::Neutral ? Tool::Look : Tool::Neutral; }, hasSet,
                 [this] { return m_tool == Tool::Neutral; }});
  m_actions.add({"light.match", "Match a pixel's colour", "",
                 "Click into the picture: the chosen lights take that pixel's colour. Also Alt + click.",
                 [this] { m_tool = m_tool == Tool::Match ? Tool::Look : Tool::Match; }, hasSet,
                 [this] { return m_tool == Tool::Match; }});
  m_actions.add({"mixer.as_captured", "As captured", "", "Every light as in the first shot.",
                 [this] {
                   editRig(m_context, "As captured",
                           rigOfShot(m_editor.document().rig, *m_session.set()->solved, 0));
                 },
                 [this] { return m_session.set() && !m_session.set()->solved->capture.shots.empty(); }});
  m_actions.add({"mixer.all_white", "All white", "", "Every light on, white, without stops.",
                 [this] { editRig(m_context, "All white", allWhiteRig(m_editor.document().rig)); },
                 hasLights});
  m_actions.add({"mixer.all_off", "All off", "", "Every light off.",
                 [this] { editRig(m_context, "All off", allOffRig(m_editor.document().rig)); }, hasLights});
  m_actions.add({"mixer.import_gels", "Import gels …", "",
                 "Take a table of gels (CSV: brand, number, name, x, y, T) into the list.",
                 [this] { askForGels(); }});
}

void StudioWindow::askForGels() {
  m_chooser.ask({"Import a table of gels",
                 "Import",
                 {".csv"},
                 false,
                 "",
                 {},
                 [this](const std::filesystem::path& file) {
                   try {
                     const size_t count = importGels(file);
                     m_messages.info(fmt::format("{} gels from {}", count, file.filename().string()));
                   } catch (const InputError& error) {
                     m_messages.error(error.what());
                   }
                 }});
}

}  // namespace swaplight
