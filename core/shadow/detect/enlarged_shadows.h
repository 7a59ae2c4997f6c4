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
/// In a small window a light without its shadows is a linear function of what the other lights show there; so
/// what of it arrives, q, is known at full size. The visibility is in turn a linear function of q in the
/// window, which is fitted where it was found and applied at full size (He and Sun, "Fast guided filter",
/// 2015), and stays within what was found around the place. `small`, `found`: a light each, in the set's
/// order.
[[nodiscard]] std::vector<LightShadows> enlargedShadows(const SolvedSet& set, const SolvedSet& small,
                                                        std::vector<LightShadows> found,
                                                        const Progress& progress,
                                                        const ShadowTuning& tuning = {});

}  // namespace swaplight
