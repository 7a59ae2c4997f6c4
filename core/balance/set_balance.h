#pragma once

#include <span>

#include "core/color/rgb.h"
#include "core/image/image.h"
#include "core/set/solved_set.h"
#include "core/solve/model/noise_model.h"

namespace swaplight {

/// What each lamp of a set gave in a photograph, and what it is to give: linear, the set's primaries.
struct LampBalance {
  std::vector<Rgb> lamps;
  std::vector<Rgb> targets;  ///< of a white balance: the white point at the lamp's own luminance
  float ambient = 1;         ///< level of the set's ambient light in the photograph; stays
};

/// White balance under many lights (Lindsay 2013, 6.4, corrected): a photograph of a solved set as it would
/// be with its lamps in other colours. Per pixel and channel, with P = sum of l_i T_i what the set says of it
/// and Q = sum of t_i T_i what is wanted,
///
///   out = Q + k (Q / P) (y - P)
///
/// The photograph's own y Q / P is right also where something is in it that the set does not have (an actor),
/// but divides its noise by a lamp's colour; Q has no such noise, but only what is in the set. So the
/// difference counts as far as it is more than noise: k = 1 - var / mean of (y - P)^2 over 9 x 9 pixels, at
/// least 0 (an empirical Wiener filter, as in Lee 1980). Q / P lies between the lamps' own ratios: no
/// division by nothing. Where the photograph is clipped, the set speaks.
///
/// `photograph`: of loadPhotographOf, finite; `clip` its clip level. The result is finite.
[[nodiscard]] Image balanceBySet(const SolvedSet& set, const Image& photograph, float clip,
                                 const LampBalance& balance, const NoiseModel& noise);

/// Targets of luminance Y(l_i) at a white; lamps that are not chosen keep their colour. `white` is in the
/// set's primaries.
[[nodiscard]] std::vector<Rgb> whiteTargets(const std::vector<Rgb>& lamps, std::span<const size_t> chosen,
                                            const Rgb& white, const Rgb& luminanceWeights);

}  // namespace swaplight
