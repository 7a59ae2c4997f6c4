#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/control/editing_context.h"

namespace swaplight {

// How the page of the shadows reads and changes the document.

/// Whether the page is to be seen.
[[nodiscard]] bool shadowsShown(const EditingContext& studio);
/// The light whose shadows are shown, by its place in the set as solved; -1: a light that edits have added,
/// which has none.
[[nodiscard]] int shadowLight(const ChosenLights& lights, const OpenSet& set);

/// The threshold that the person has given a light.
[[nodiscard]] std::optional<float> shadowThresholdOf(const Document& document, const std::string& light);
/// Shows another threshold while a gesture goes on.
void previewShadowThreshold(const EditingContext& studio, const std::string& light, float threshold);
/// The light finds its threshold by itself again, as one step.
void resetShadowThreshold(const EditingContext& studio, const std::string& light);

/// Kinds of shadow edits that one slider makes.
using ShadowKinds = std::vector<ShadowOperation::Kind>;

/// The edit that the page makes for the chosen shadow, or for all of the light, with one of these kinds: its
/// place in the list, or -1. One that is switched off does not count.
[[nodiscard]] int shadowEdit(const EditingContext& studio, const std::string& light,
                             const ShadowKinds& kinds);
/// What that edit does; an operation of the first kind with amount 0 where there is none.
[[nodiscard]] ShadowOperation shadowOperation(const EditingContext& studio, const std::string& light,
                                              const ShadowKinds& kinds);
/// The document in which that edit does something else: it comes into being, and goes where nothing is left
/// to do.
[[nodiscard]] Document withShadowOperation(const EditingContext& studio, const std::string& light,
                                           const ShadowKinds& kinds, const ShadowOperation& operation);

}  // namespace swaplight
