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
/// Puts all there is now into the gallery: lighting, light edits, view and camera look.
void keepVersion(const LightsContext& lights);
/// Brings back a look of the gallery (its lighting) or a version (all of it).
void recallLook(const LightsContext& lights, const SavedLook& look);
/// The gallery with one change, as one step.
void editLooks(const LightsContext& lights, const std::string& step, std::vector<SavedLook> looks);
/// One look's name, and that of its cues; a look less, with its cues.
void renameLook(const LightsContext& lights, size_t look, const std::string& name);
void removeLook(const LightsContext& lights, size_t look);
/// Puts what there is now in the place of a look or version, which stays what it is.
void replaceLook(const LightsContext& lights, size_t look);
/// Makes a look side B of the viewer, and wipes.
void wipeAgainstLook(const LightsContext& lights, const SavedLook& look);
/// Shows a lighting between two looks.
void previewCrossfade(const LightsContext& lights, const SavedLook& a, const SavedLook& b, float amount);

}  // namespace swaplight
