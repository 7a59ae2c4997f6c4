#include "ui/panel_layout.h"

#include <algorithm>
#include <exception>

#include "core/file/json_file.h"

namespace swaplight {

PanelLayout readPanelLayout(const std::filesystem::path& file) {
  PanelLayout layout;
  try {
    if (!std::filesystem::exists(file)) return layout;
    const Json json = readJson(file);
    layout.mixer = json.value("mixer", layout.mixer);
    layout.scopes = json.value("scopes", layout.scopes);
    layout.mixerWidth = std::clamp(json.value("mixer_width", layout.mixerWidth), 300.0F, 900.0F);
    layout.scopesHeight = std::clamp(json.value("scopes_height", layout.scopesHeight), 120.0F, 900.0F);
  } catch (const std::exception&) {
    return {};
  }
  return layout;
}

void writePanelLayout(const PanelLayout& layout, const std::filesystem::path& file) {
  try {
    std::filesystem::create_directories(file.parent_path());
    writeJson(Json{{"mixer", layout.mixer},
                   {"scopes", layout.scopes},
                   {"mixer_width", layout.mixerWidth},
                   {"scopes_height", layout.scopesHeight}},
              file);
  } catch (const std::exception&) {
    return;
  }
}

}  // namespace swaplight
