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

/// Its name; empty where it has none. Of the set that is open.
[[nodiscard]] std::string shownShadowLight(const EditingContext& studio);

/// The threshold that the person has given a light.
[[nodiscard]] std::optional<float> shadowThresholdOf(const Document& document, const std::string& light);
/// Shows another threshold while a gesture goes on.
void previewShadowThreshold(const EditingContext& studio, const std::string& light, float threshold);
/// The light finds its threshold by itself again, as one step.
void resetShadowThreshold(const EditingContext& studio, const std::string& light);

/// What the person has said of places of a light's shadows.
[[nodiscard]] const ShadowMarks& shadowMarksOf(const Document& document, const std::string& light);
/// Says of a place that it is in shadow or lit, as one step. A mark within `reach` pixels of it goes where it
/// says the same, else it becomes this one.
void markShadow(const EditingContext& studio, const std::string& light, const ShadowMark& mark, float reach);
/// Forgets all of a light's marks, as one step.
void clearShadowMarks(const EditingContext& studio, const std::string& light);

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
