#pragma once

#include <array>
#include <filesystem>
#include <utility>

#include "core/view/scopes/scope_scale.h"

namespace swaplight {

/// Which scopes are shown, and of what.
struct ScopeOptions {
  enum class Of { Frame, Region, Light };
  enum class Axis { Codes, Stops, Linear };
  bool waveform = true, parade = false, vectorscope = true, histogram = true, chromaticity = false;
  Of of = Of::Frame;
  Axis histogramAxis = Axis::Codes;
  ScopeUnit unit = ScopeUnit::Codes8;
  bool logCounts = false;
  bool operator==(const ScopeOptions&) const = default;
};

/// Which panels are open and how large: the person's own, the same for every session. Lengths at scale 1.
struct PanelLayout {
  bool mixer = true;
  bool scopes = false;
  bool tools = true;
  bool edits = false;
  bool shadows = false;  ///< over the list of the edits
  bool gallery = false;
  bool cameraLook = false;
  bool threePoint = false;  ///< in the place of the light's colour
  bool commandLine = false;
  bool cues = false;
  bool grade = false;
  bool hidden = false;  ///< everything but the viewer
  float mixerWidth = 372;
  float scopesHeight = 228;
  ScopeOptions scopeOptions;
  bool operator==(const PanelLayout&) const = default;
};

/// The panels, by their names in the file.
inline constexpr std::array<std::pair<const char*, bool PanelLayout::*>, 11> kPanelNames = {
    {{"mixer", &PanelLayout::mixer},
     {"scopes", &PanelLayout::scopes},
     {"tools", &PanelLayout::tools},
     {"edits", &PanelLayout::edits},
     {"shadows", &PanelLayout::shadows},
     {"gallery", &PanelLayout::gallery},
     {"camera_look", &PanelLayout::cameraLook},
     {"three_point", &PanelLayout::threePoint},
     {"command_line", &PanelLayout::commandLine},
     {"cues", &PanelLayout::cues},
     {"grade", &PanelLayout::grade}}};

/// Defaults where the file is not there or cannot be read.
[[nodiscard]] PanelLayout readPanelLayout(const std::filesystem::path& file);
/// A layout that cannot be written is no reason to stop anybody.
void writePanelLayout(const PanelLayout& layout, const std::filesystem::path& file);

}  // namespace swaplight
