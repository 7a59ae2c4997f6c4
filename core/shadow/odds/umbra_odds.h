#pragma once

#include "core/shadow/odds/umbra_evidence.h"
#include "core/shadow/odds/umbra_network.h"

namespace swaplight {

/// The odds of one light's umbra at the size of `set`'s pictures, as the network sees them (larger ones at
/// the size that it was taught on) and half as large: there noise is half as strong and a dark wall one
/// surface (what stays of noise in a solved set is blotches, which the network takes for shapes). Empty
/// pictures where there is nothing to weigh: a light that is the same everywhere.
[[nodiscard]] LightOdds umbraOdds(const SmallSet& set, size_t light);

}  // namespace swaplight
