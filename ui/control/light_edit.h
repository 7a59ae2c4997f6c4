#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/session/document_editor.h"
#include "ui/state/view_state.h"

namespace swaplight {

/// The document's lights, and which of them are chosen.
struct ChosenLights {
  DocumentEditor& editor;
  ViewState& view;

  [[nodiscard]] const Document& document() const { return editor.document(); }
};

// How the panels change lights. What is touched on a light that is one of several chosen ones changes on all
// of them.

/// The lights that a change of `light` is for.
[[nodiscard]] std::vector<size_t> lightsFor(const ChosenLights& chosen, size_t light);
/// The light whose colour is shown; the rig has at least one.
[[nodiscard]] size_t shownLight(const ChosenLights& chosen);

using LightChange = std::function<void(LightSetting&)>;
/// Shows lights changed while a gesture goes on; `what` names the step, as "colour".
void previewLights(const ChosenLights& chosen, size_t light, const std::string& what,
                   const LightChange& change);
/// Changes lights as one step.
void editLights(const ChosenLights& chosen, size_t light, const std::string& what, const LightChange& change);
/// Shows lights brighter by stops, also those that are locked to them.
void previewStops(const ChosenLights& chosen, size_t light, float stops);
/// Shows lights brighter so that `light` is at a level (core/relight/level.h); the others by as much.
void previewLevel(const ChosenLights& chosen, size_t light, double level);
/// Brings every one of the lights to a level as one step.
void editLevel(const ChosenLights& chosen, size_t light, double level);
/// Another rig as one step.
void editRig(const ChosenLights& chosen, const std::string& step, const Rig& rig);

/// Solo on one light: `alone` switches the others' off.
void toggleSolo(const ChosenLights& chosen, size_t light, bool alone);

}  // namespace swaplight
