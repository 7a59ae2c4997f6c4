#pragma once

#include "core/set/solved_set.h"

namespace swaplight {

/// Where the edge of a light's shadow is the outline of what stands before it: 0..1, one channel. What the
/// edge divides there lies at two depths; no penumbra goes over it.
///
/// A cast edge is the light's own. At an outline the surface changes, too, and with it what the other lights
/// show: their logarithm follows the visibility there (squared correlation in a window, in one channel at
/// least). A single spot of paint under a cast edge does so as well, so that most of the edge around has to.
/// Nothing is found where the other lights show no difference, and of a set of one light.
///
/// `visibility`: of light number `light`, one channel, of the set's size. The result may be smaller.
[[nodiscard]] Image shadowSilhouettes(const Image& visibility, const SolvedSet& set, size_t light);

}  // namespace swaplight
