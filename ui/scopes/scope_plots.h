#pragma once

#include <imgui.h>

#include <vector>

#include "core/relight/rig.h"
#include "core/view/scopes/scope_pictures.h"
#include "render/surface.h"
#include "ui/state/panel_layout.h"

namespace swaplight {

/// The scopes that are pictures, on the graphics card.
struct ScopeTextures {
  SurfaceTexture waveform, parade, vectorscope, chromaticity;
};

// One scope each, with its axes, filling a rectangle of the screen.

/// `columns`: 1 for a waveform, 3 for a parade. `scale`: the lines of the display codes.
void drawWaveform(unsigned texture, int columns, const std::vector<ScopeTick>& scale, ImVec2 low,
                  ImVec2 high);
void drawVectorscope(unsigned texture, ImVec2 low, ImVec2 high);
/// With the lights of the rig, black bodies and the border of all colours.
void drawChromaticity(const std::vector<LightSetting>& lights, unsigned texture, ImVec2 low, ImVec2 high);
/// `scale`: of the axis of display codes.
void drawHistogram(const ScopePictures& pictures, const ScopeOptions& options, std::vector<ScopeTick> scale,
                   ImVec2 low, ImVec2 high);

}  // namespace swaplight
