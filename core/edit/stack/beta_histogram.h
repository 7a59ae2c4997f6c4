#pragma once

#include <vector>

#include "core/set/solved_set.h"

namespace swaplight {

/// How much of the picture has which beta, 0..1 in `bins` even steps, of one light or (light < 0) all of
/// them; the most frequent is 1. Roots of the counts, so that the rare is seen. Pixels without light do not
/// count; of large pictures every few pixels.
[[nodiscard]] std::vector<float> betaHistogram(const SolvedSet& set, int light, int bins);

}  // namespace swaplight
