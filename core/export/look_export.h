#pragma once

#include <filesystem>
#include <string>

#include "core/ocio/color_config.h"
#include "core/relight/rig.h"
#include "core/session/document.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// What of a lighting is the same for every pixel, and so fits into a table or a colour decision list: the
/// one gain a channel that brings the set under white light nearest to the relit one,
///   gain_c = sum(white_c relit_c) / sum(white_c^2).
/// What each light does on its own is spatial and is not in it.
struct GlobalLook {
  Rgb gain{1, 1, 1};
  double explained = 1;  ///< how much of the relit picture's energy the gain reproduces, 0..1
};
[[nodiscard]] GlobalLook globalLook(const ColorConfig& config, const SolvedSet& set, const Rig& rig);

/// True for .cube, .ccc and .cc: see writeLook.
[[nodiscard]] bool isLookFile(const std::filesystem::path& file);

/// Writes the global part of a look, and says in the file that it is only that:
///   .ccc, .cc  an ASC CDL colour correction: slope = gain, on scene-linear light
///   .cube      33 x 33 x 33 table from ACEScct through gain and view to the display's code values
/// Throws InputError where the file cannot be written, or the display, the view or a look is unknown.
void writeLook(const ColorConfig& config, const GlobalLook& look, const DisplayChoice& display,
               const std::filesystem::path& file);

}  // namespace swaplight
