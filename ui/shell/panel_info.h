#pragma once

#include <imgui.h>

#include <functional>
#include <string>

#include "ui/state/panel_layout.h"

namespace swaplight {

/// At which side of the viewer a panel stands.
enum class Dock {
  Left,
  Right,
  Bottom,
  Inside,  ///< a page of another panel, which draws it
};

/// A length that the person can change by a splitter.
struct PanelSize {
  float PanelLayout::*length = nullptr;  ///< at scale 1
  float least = 0, most = 0;
};

/// All that the window knows of a panel: its action, its line in the menu, its place.
struct PanelInfo {
  const char* id;  ///< of the action that shows and hides it: "view.mixer"
  const char* name;
  const char* keys;
  const char* tooltip;
  bool PanelLayout::*open;
  Dock dock = Dock::Inside;
  float size = 0;  ///< width or height at scale 1, where the person cannot change it
  PanelSize ownSize = {};
  ImVec2 padding = {};  ///< at scale 1
  ImGuiWindowFlags flags = 0;
  std::function<bool()> available = {};  ///< empty: always
  std::function<void()> draw = {};       ///< fills Dear ImGui's window

  /// "mixer"
  [[nodiscard]] std::string shortName() const {
    return std::string(id).substr(std::string(id).find('.') + 1);
  }
  [[nodiscard]] bool isShown(const PanelLayout& layout) const {
    return !layout.hidden && layout.*open && (!available || available());
  }
};

}  // namespace swaplight
