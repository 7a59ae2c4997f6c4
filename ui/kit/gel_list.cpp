#include "ui/kit/gel_list.h"

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "core/base/error.h"
#include "core/lamp/gel.h"
#include "ui/kit/action_widgets.h"
#include "ui/kit/layout_probe.h"
#include "ui/kit/light_words.h"
#include "ui/kit/theme.h"
#include "ui/kit/widgets.h"

namespace swaplight {
namespace {

/// "full ctb" finds "Full CT Blue": the name counts without its blanks, too.
bool matches(const Gel& gel, const std::string& filter) {
  std::string together = gel.name;
  std::erase(together, ' ');
  return matchesWords(gel.id + " " + gel.name + " " + together, filter);
}

/// White light through the gel.
Rgb gelChip(const Gel& gel) {
  LightColor color;
  color.gel = gel.id;
  return chipColor(color);
}

std::string gelWords(const std::string& id) {
  if (id.empty()) return "none";
  try {
    return id + "  " + findGel(id).name;
  } catch (const InputError&) {
    return id + "  (unknown here)";
  }
}

bool gelLine(const Gel& gel, bool current) {
  const std::string label = fmt::format("      {}  {}  ({})", gel.id, gel.name, sourceName(gel.source));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::Selectable(label.c_str(), current);
  const float side = ImGui::GetTextLineHeight();
  ImGui::GetWindowDrawList()->AddRectFilled(
      ImVec2(at.x + px(2), at.y), ImVec2(at.x + px(2) + side, at.y + side), colorU32(gelChip(gel)), px(3));
  markItem({"gel.", gel.id});
  return clicked;
}

}  // namespace

std::optional<std::string> gelChoices(const std::string& current, std::string& filter, bool orNone) {
  std::optional<std::string> chosen;
  if (ImGui::IsWindowAppearing()) {
    filter.clear();
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::SetNextItemWidth(px(330));
  const bool entered = ImGui::InputTextWithHint("##filter", "Maker and number, or name", &filter,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  markItem("gel.filter");
  if (orNone) {
    if (ImGui::Selectable("      none", current.empty())) chosen = "";
    markItem("gel.remove");
  }
  try {
    bool any = false;
    for (const Gel& gel : allGels()) {
      if (!matches(gel, filter)) continue;
      any = true;
      if (gelLine(gel, gel.id == current) || (entered && !chosen)) chosen = gel.id;
    }
    if (!any) {
      hint("No such gel. Try a number, or a word of its name.");
      markItem("gel.none");
    }
  } catch (const InputError& error) {
    ImGui::TextWrapped("%s", error.what());
  }
  return chosen;
}

std::optional<std::string> gelCombo(const char* id, const std::string& current, std::string& filter,
                                    const ActionTable& actions) {
  if (!ImGui::BeginCombo(id, gelWords(current).c_str(), ImGuiComboFlags_HeightLarge)) return std::nullopt;
  std::optional<std::string> chosen;
  if (const auto gel = gelChoices(current, filter, true)) chosen = gel;
  ImGui::Separator();
  actionMenuItem(actions, "mixer.import_gels");
  if (chosen) ImGui::CloseCurrentPopup();
  ImGui::EndCombo();
  return chosen;
}

}  // namespace swaplight
