#include "ui/layout_probe.h"

#include <imgui.h>

#include <cmath>
#include <optional>

#include "core/file/json_file.h"
#include "core/json.h"

namespace swaplight {
namespace {

struct Probe {
  std::filesystem::path file;
  Json items = Json::object();
  Json state = Json::object();
  Json written;
};

std::optional<Probe>& probe() {
  static std::optional<Probe> instance;
  return instance;
}

}  // namespace

void probeLayout(const std::filesystem::path& file) {
  probe().emplace();
  probe()->file = file;
}

void markItem(const std::string& name) {
  if (!probe() || !ImGui::IsItemVisible()) return;
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  markRect(name, low.x, low.y, high.x, high.y);
}

void markRect(const std::string& name, float x0, float y0, float x1, float y1) {
  if (!probe()) return;
  probe()->items[name] = {std::round(x0), std::round(y0), std::round(x1), std::round(y1)};
}

void markState(const std::string& name, const std::string& value) {
  if (probe()) probe()->state[name] = value;
}

void endLayoutFrame() {
  if (!probe()) return;
  Json layout = probe()->state;
  layout["items"] = std::move(probe()->items);
  probe()->items = Json::object();
  if (layout == probe()->written) return;
  writeJson(layout, probe()->file);
  probe()->written = std::move(layout);
}

}  // namespace swaplight
