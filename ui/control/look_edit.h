#pragma once

#include "core/look/look.h"
#include "ui/control/studio_context.h"

namespace swaplight {

// How panels and actions change a lighting as a whole.

/// How bright the open set's lights are against each other; measured when first asked for. There is a set.
[[nodiscard]] const LightRatios& lightRatios(StudioContext& studio);

/// A preset over the lighting of now, as one step. What goes wrong becomes a message.
void applyPreset(StudioContext& studio, const Look& look);
/// The preset that was applied last, as long as nothing else has been done since; else nullptr.
[[nodiscard]] const LookState::Blend* activeBlend(const StudioContext& studio);
/// Shows it in part: 0 is what was before.
void previewBlend(StudioContext& studio, float amount);

/// Puts the lighting of now into the gallery.
void keepLook(StudioContext& studio);
/// Lights the set as a look of the gallery says.
void recallLook(StudioContext& studio, const SavedLook& look);
/// The gallery with one change, as one step.
void editLooks(StudioContext& studio, const std::string& step, std::vector<SavedLook> looks);
/// Makes a look side B of the viewer, and wipes.
void wipeAgainstLook(StudioContext& studio, const SavedLook& look);
/// Shows a lighting between two looks.
void previewCrossfade(StudioContext& studio, const SavedLook& a, const SavedLook& b, float amount);

}  // namespace swaplight
