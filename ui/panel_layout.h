#pragma once

#include <filesystem>

namespace swaplight {

/// Which panels are open and how large: the person's own, the same for every session. Lengths at scale 1.
struct PanelLayout {
  bool mixer = true;
  bool scopes = false;
  bool hidden = false;  ///< everything but the viewer
  float mixerWidth = 372;
  float scopesHeight = 220;
  bool operator==(const PanelLayout&) const = default;
};

/// Defaults where the file is not there or cannot be read.
[[nodiscard]] PanelLayout readPanelLayout(const std::filesystem::path& file);
/// A layout that cannot be written is no reason to stop anybody.
void writePanelLayout(const PanelLayout& layout, const std::filesystem::path& file);

}  // namespace swaplight
