#include "ui/kit/keys_window.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "ui/actions/key_file.h"
#include "ui/kit/echo_key.h"
#include "ui/kit/icons.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

struct Group {
  const char* prefix;
  const char* title;
};
constexpr Group kGroups[] = {{"file.", "File"},        {"edit.", "Edit"},     {"light.", "Selected light"},
                             {"mixer.", "All lights"}, {"view.", "View"},     {"channel.", "Channels"},
                             {"compare.", "Compare"},  {"scopes.", "Scopes"}, {"looks.", "Looks"},
                             {"window.", "Window"},    {"help.", "Help"}};

/// What the mouse does, which no key table holds.
void mouseHelp() {
  ImGui::PushFont(fonts().strong);
  ImGui::TextUnformatted("Mouse");
  ImGui::PopFont();
  for (const char* text :
       {"Wheel: zoom at the pointer", "Drag: pan", "Alt + click: match the light to a pixel",
        "Hold Q: which light is this? Click selects it", "Hold E + drag: viewer exposure",
        "Double-click a slider: reset to the capture", "Ctrl + click a slider: type a value",
        "Shift + drag a level: finely", "Wheel or arrows over a level: steps",
        "Ctrl or Shift + click lights: select several", "Right-click a light: context menu"})
    hint(text);
}

bool isModifier(const std::string& key) {
  return key == "Ctrl" || key == "Shift" || key == "Alt";
}

}  // namespace

void KeysWindow::drawGroup(ActionTable& actions, const std::string& group) {
  for (const Action& action : actions.actions()) {
    if (!action.id.starts_with(group)) continue;
    if (!matchesWords(action.name + " " + action.keys + " " + action.tooltip, m_filter)) continue;
    ImGui::PushID(action.id.c_str());
    const float width = px(126);
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - px(12);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(action.name.c_str());
    tooltip(action.tooltip.c_str());
    ImGui::SameLine();
    ImGui::SetCursorPosX(right - width);
    const bool waiting = m_waiting == action.id;
    if (waiting) ImGui::PushStyleColor(ImGuiCol_Button, kAccent);
    const bool changed = action.keys != action.ownKeys;
    if (changed) ImGui::PushStyleColor(ImGuiCol_Text, kChanged);
    if (ImGui::Button(waiting ? "press a shortcut \u2026" : (action.firstKeys() + "##keys").c_str(),
                      ImVec2(width, 0)))
      m_waiting = waiting ? "" : action.id;
    if (changed) ImGui::PopStyleColor();
    if (waiting) ImGui::PopStyleColor();
    markItem({"keys.", action.id});
    tooltip(
        "Click, then press the new shortcut. Backspace clears it, Escape cancels, right-click restores the "
        "default.");
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
      actions.setKeys(action.id, action.ownKeys);
      writeKeyFile(actions, m_file);
    }
    ImGui::PopID();
  }
}

void KeysWindow::takeKeys(ActionTable& actions, const Keyboard& keyboard, Messages& messages) {
  for (const KeyPress& press : keyboard.presses) {
    if (isModifier(press.key) || press.key.empty() || press.key == kEchoKey) continue;
    if (press.key != "Escape") {
      const std::string keys = press.key == "Backspace" ? "" : keysName(press);
      for (const Action& other : actions.actions())
        if (!keys.empty() && other.id != m_waiting && other.firstKeys() == keys) {
          messages.info(keys + " was \u201c" + other.name + "\u201d, which now has no shortcut.");
          actions.setKeys(other.id, "");
        }
      actions.setKeys(m_waiting, keys);
      writeKeyFile(actions, m_file);
    }
    m_waiting.clear();
    return;
  }
}

void KeysWindow::draw(ActionTable& actions, const Keyboard& keyboard, Messages& messages) {
  if (!m_open) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Always, ImVec2(0.5F, 0.5F));
  ImGui::SetNextWindowSize(
      ImVec2(std::min(px(1120), screen.x - px(40)), std::min(px(860), screen.y - px(60))));
  const bool wasWaiting = !m_waiting.empty();
  if (ImGui::Begin("Keyboard shortcuts", &m_open,
                   ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                       ImGuiWindowFlags_NoSavedSettings)) {
    ImGui::SetNextItemWidth(px(320));
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    ImGui::InputTextWithHint("##filter", "Search", &m_filter);
    markItem("keys.filter");
    ImGui::SameLine();
    hint("Click a shortcut to change it. Saved in " + m_file.string());
    ImGui::BeginChild("##groups");
    const int columns = std::clamp(static_cast<int>(ImGui::GetContentRegionAvail().x / px(330)), 1, 3);
    if (ImGui::BeginTable("##columns", columns)) {
      // Each column gets whole groups, as many as bring it to its part of the lines.
      const auto total = static_cast<int>(actions.actions().size()) + static_cast<int>(std::size(kGroups));
      int lines = 0;
      ImGui::TableNextColumn();
      for (const Group& group : kGroups) {
        const auto count =
            std::count_if(actions.actions().begin(), actions.actions().end(),
                          [&](const Action& action) { return action.id.starts_with(group.prefix); });
        if (count == 0) continue;
        if (lines > 0 && (lines + count / 2) * columns > total * (ImGui::TableGetColumnIndex() + 1) &&
            ImGui::TableGetColumnIndex() + 1 < columns)
          ImGui::TableNextColumn();
        lines += static_cast<int>(count) + 1;
        ImGui::PushFont(fonts().strong);
        ImGui::TextUnformatted(group.title);
        ImGui::PopFont();
        drawGroup(actions, group.prefix);
        ImGui::Dummy(ImVec2(0, px(6)));
      }
      mouseHelp();
      ImGui::EndTable();
    }
    ImGui::EndChild();
  }
  ImGui::End();
  if (wasWaiting && !m_waiting.empty()) takeKeys(actions, keyboard, messages);
  if (!m_open) m_waiting.clear();
}

}  // namespace swaplight
