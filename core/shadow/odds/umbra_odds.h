#pragma once

#include "core/shadow/odds/umbra_evidence.h"
#include "core/shadow/odds/umbra_network.h"

namespace swaplight {

/// The odds of one light's umbra at the small size of `set`'s pictures. Empty pictures where there is nothing
/// to weigh: a light that is the same everywhere.
[[nodiscard]] LightOdds umbraOdds(const SmallSet& set, size_t light);

}  // namespace swaplight
