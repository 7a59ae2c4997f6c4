#include "ui/kit/layout_probe.h"

#include <imgui.h>

#include <cmath>
#include <optional>
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
  Json last = Json::object();  ///< the frame's items before
};

std::optional<Probe>& probe() {
  static std::optional<Probe> instance;
  return instance;
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
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  markRect(name, low.x, low.y, high.x, high.y);
}

void markRect(std::initializer_list<NamePart> name, float x0, float y0, float x1, float y1) {
  if (!probe()) return;
  std::string whole;
  for (const NamePart& part : name) part.appendTo(whole);
  probe()->items[whole] = {std::round(x0), std::round(y0), std::round(x1), std::round(y1)};
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
  if (layout == probe()->written) return;
  writeJson(layout, probe()->file);
  probe()->written = std::move(layout);
}

}  // namespace swaplight
