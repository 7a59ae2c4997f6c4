#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/set/solved_set.h"
#include "core/shadow/evidence/shadow_tuning.h"
#include "core/shadow/result/light_shadows.h"

namespace swaplight {

/// Shadows that were found on a set made smaller (shrunkSet), brought to the set's own size; the fine detail
/// is taken from its contributions.
///
/// A light without its shadows is at any place a smooth multiple of what the other lights show there; what of
/// it arrives, q, is known at full size, then. The visibility is a linear function of q in a small window,
/// which is fitted where it was found and applied at full size (He and Sun, "Fast guided filter", 2015), and
/// stays within what was found around the place. `small`, `found`: a light each, in the set's order.
[[nodiscard]] std::vector<LightShadows> enlargedShadows(const SolvedSet& set, const SolvedSet& small,
                                                        std::vector<LightShadows> found,
                                                        const Progress& progress,
                                                        const ShadowTuning& tuning = {});

}  // namespace swaplight
