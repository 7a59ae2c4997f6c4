#pragma once

#include "core/base/progress.h"
#include "core/set/solved_set.h"

namespace swaplight {

/// What of each light is highlight, as far as the lights show it: fills in SolvedSet::highlights, and their
/// part of the picture in the report. Nothing else changes; where none are found the set stays as it is.
///
/// A matte surface gives each light's contribution the same colour; a highlight is of the lamp's own colour,
/// white (Shafer 1985), and makes that of its light less colourful: T = b rho + g (1 1 1). With n, the length
/// of what the channels differ from their mean m by, over m, and n_rho that of rho: g = m - m n / n_rho.
/// n_rho is that of the light that is most colourful at the pixel; where a bright highlight drowns the others
/// in its noise, that of the surfaces around it, if this light alone is brighter than around it. So it is a
/// lower bound: what is white in all lights is taken for a surface. Significant ones only (3 standard errors
/// by quality.sigma), less what of them may be noise. Grey surfaces show none.
///
/// Looks at some 30,000 pixels first; at all of them only where these show highlights. Throws Stopped.
void findHighlights(SolvedSet& set, const Progress& progress = {});

}  // namespace swaplight
