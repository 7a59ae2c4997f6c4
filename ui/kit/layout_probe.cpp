#include "ui/kit/layout_probe.h"

#include <imgui_internal.h>

#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/base/json.h"
#include "core/file/json_file.h"

namespace swaplight {
namespace {

struct Probe {
  std::filesystem::path file;
  Json items = Json::object();
  Json state = Json::object();
  Json written;
  std::string focus;                       ///< the item that the keyboard goes to
  std::map<std::string, ImGuiID> numbers;  ///< of the items that have one: text has none
  std::set<ImGuiID> told;                  ///< those that have a tooltip
  Json last = Json::object();              ///< the frame's items before
};

std::optional<Probe>& probe() {
  static std::optional<Probe> instance;
  return instance;
}

/// Items without a tooltip.
Json untold(const Probe& probe) {
  Json names = Json::array();
  for (const auto& [name, number] : probe.numbers)
    if (probe.told.count(number) == 0) names.push_back(name);
  return names;
}

std::string wholeName(std::initializer_list<NamePart> name) {
  std::string whole;
  for (const NamePart& part : name) part.appendTo(whole);
  return whole;
}

}  // namespace

void rememberLayout() {
  if (!probe()) probe().emplace();
}

std::optional<ItemRect> itemRect(const std::string& name) {
  if (!probe() || !probe()->last.contains(name)) return std::nullopt;
  const Json& rect = probe()->last[name];
  return ItemRect{rect[0], rect[1], rect[2], rect[3]};
}

void probeLayout(const std::filesystem::path& file) {
  rememberLayout();
  probe()->file = file;
}

void NamePart::appendTo(std::string& name) const {
  if (m_number)
    name += std::to_string(*m_number);
  else
    name += m_text;
}

void markItem(std::initializer_list<NamePart> name) {
  if (!probe() || !ImGui::IsItemVisible()) return;
  if (ImGui::IsItemFocused() || ImGui::IsItemActive()) probe()->focus = wholeName(name);
  const ImGuiID number = ImGui::GetItemID();
  if (number != 0 && !probe()->file.empty()) probe()->numbers[wholeName(name)] = number;
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  markRect(name, low.x, low.y, high.x, high.y);
}

void markTip() {
  if (probe() && !probe()->file.empty()) probe()->told.insert(ImGui::GetItemID());
}

void markRect(std::initializer_list<NamePart> name, float x0, float y0, float x1, float y1) {
  if (!probe()) return;
  probe()->items[wholeName(name)] = {std::round(x0), std::round(y0), std::round(x1), std::round(y1)};
}

void markState(std::string_view name, std::string_view value) {
  if (probe()) probe()->state[std::string(name)] = value;
}

void endLayoutFrame() {
  if (!probe()) return;
  Json layout = probe()->state;
  probe()->last = std::exchange(probe()->items, Json::object());
  if (probe()->file.empty()) return;
  layout["items"] = probe()->last;
  layout["focus"] = std::exchange(probe()->focus, {});
  layout["untold"] = untold(*probe());
  probe()->numbers.clear();
  probe()->told.clear();
  if (layout == probe()->written) return;
  writeJson(layout, probe()->file);
  probe()->written = std::move(layout);
}

}  // namespace swaplight
