#pragma once

#include "core/look/look.h"
#include "ui/control/lights_context.h"

namespace swaplight {

// How panels and actions change a lighting as a whole.

/// How bright the open set's lights are against each other; measured when first asked for. There is a set.
[[nodiscard]] const LightRatios& lightRatios(const LightsContext& lights);

/// A preset over the lighting of now, as one step. What goes wrong becomes a message.
void applyPreset(const LightsContext& lights, const Look& look);
/// The preset that was applied last, as long as nothing else has been done since; else nullptr.
[[nodiscard]] const LookState::Blend* activeBlend(const LightsContext& lights);
/// Shows it in part: 0 is what was before.
void previewBlend(const LightsContext& lights, float amount);

/// Puts the lighting of now into the gallery.
void keepLook(const LightsContext& lights);
/// Lights the set as a look of the gallery says.
void recallLook(const LightsContext& lights, const SavedLook& look);
/// The gallery with one change, as one step.
void editLooks(const LightsContext& lights, const std::string& step, std::vector<SavedLook> looks);
/// Makes a look side B of the viewer, and wipes.
void wipeAgainstLook(const LightsContext& lights, const SavedLook& look);
/// Shows a lighting between two looks.
void previewCrossfade(const LightsContext& lights, const SavedLook& a, const SavedLook& b, float amount);

}  // namespace swaplight
