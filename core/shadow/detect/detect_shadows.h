#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/json_fwd.h"
#include "core/base/progress.h"
#include "core/set/solved_set.h"
#include "core/shadow/evidence/shadow_tuning.h"
#include "core/shadow/result/light_shadows.h"
#include "core/shadow/result/shadow_options.h"

namespace swaplight {

/// Finds the shadows of every light of a set, in the set's order. Works on the contributions alone: no
/// geometry, no direction of light. With one light only, its shadows cannot be told from dark surfaces, and
/// are guessed from the level alone. Sets of more than 1280 pixels across or down are searched at a half, a
/// third ... of their size; borders and grain are those of the set itself again (enlarged_shadows.h).
[[nodiscard]] std::vector<LightShadows> detectShadows(const SolvedSet& set, const ShadowOptions& options = {},
                                                      const Progress& progress = {},
                                                      const ShadowTuning& tuning = {});

/// What was found, for a report.
[[nodiscard]] Json jsonFromShadows(const LightShadows& shadows);

/// Finds shadows on first demand and keeps them, for edits that use shadows. Throws InputError for a light
/// that the set does not have.
[[nodiscard]] ShadowSource shadowSource(std::shared_ptr<const SolvedSet> set,
                                        const ShadowOptions& options = {});

}  // namespace swaplight
