#pragma once

#include <tuple>
#include <utility>

#include "core/shadow/evidence/penumbra_tuning.h"
#include "core/shadow/marks/mark_tuning.h"

namespace swaplight {

// The constants that steer the search for shadows. Lengths in units are pixels of a picture whose longer side
// has 480 (referenceUnit). They were chosen on the rendered sets with truth, random ones 6 to 10 in
// sight at most (tests/bench/shadow_table.py), and on seeds more that docs/shadows.md names. What changing
// each costs: scripts/make_ablation shadows.

/// Of what the contributions show (shadow_evidence.h).
struct ShadowEvidenceTuning {
  int denoiseRadius = 3;          ///< pixels, of the local Wiener filter
  double denoisedVariance = .15;  ///< of the variance that its first round leaves to the second
  float leastLight = 2e-4F;       ///< of white: what counts as black
  float noiseFloor = .5F;         ///< of the median standard error, added before logarithms are taken
  double shining = .005;          ///< share of the pixels that a light must reach to be one
  int knownRadius = 3;            ///< pixels, of the median that decides where too little light is
  double surfaceShare = .5;       ///< of the reflectance that the level does without
  double edgeBlur = 2;            ///< pixels: standard deviation, before edges are looked for

  static constexpr auto fields() {
    using T = ShadowEvidenceTuning;
    return std::tuple{std::pair{"denoise_radius", &T::denoiseRadius},
                      std::pair{"denoised_variance", &T::denoisedVariance},
                      std::pair{"least_light", &T::leastLight},
                      std::pair{"noise_floor", &T::noiseFloor},
                      std::pair{"shining", &T::shining},
                      std::pair{"known_radius", &T::knownRadius},
                      std::pair{"surface_share", &T::surfaceShare},
                      std::pair{"edge_blur", &T::edgeBlur}};
  }
};

/// Of what the other lights show of a surface (other_lights.h).
struct OtherLightsTuning {
  float dark = .004F;     ///< of white: below, they show nothing of it
  float seen = .85F;      ///< visibility from which on a light shows it well enough
  float ratioEdge = .3F;  ///< log step of theirs that a ratio is not continued over
  float meanEdge = 3;     ///< the same for means of a ratio, in such steps
  float around = 20;      ///< units: standard deviation, of the surfaces around that a light shines on

  static constexpr auto fields() {
    using T = OtherLightsTuning;
    return std::tuple{std::pair{"dark", &T::dark}, std::pair{"seen", &T::seen},
                      std::pair{"ratio_edge", &T::ratioEdge}, std::pair{"mean_edge", &T::meanEdge},
                      std::pair{"around", &T::around}};
  }
};

/// Of the level that divides shadow from light (shadow_threshold.h).
struct ShadowThresholdTuning {
  int peakReach = 4;        ///< levels, of 128: a level is best among these
  double lengthBonus = .3;  ///< exponent of the contour's length
  double areaBonus = .15;   ///< exponent of the lit share: a light is there to light something
  double fullRatio = 1.5;  ///< log ratio to the other lights by which a shadow surely falls behind lit pixels
  double leastTrust = .05;   ///< in levels that divide at the same ratio
  double usualLevel = .06;   ///< bounced light in a shadow, of what surfaces get that see the light
  double spreadBelow = 2.2;  ///< log: it may be so much less; there may be little to bounce from
  double spreadAbove = 1.4;  ///< log: or so much more
  double leastEdge = .02;    ///< unshared log step a pixel along a contour: less is shading
  float smallestUnit = .5F;  ///< reference unit below which pictures blur their edges no further
  float outside = 3;         ///< log, beyond nearly all pixels' levels: surely lit, or surely shadow
  double alike = .93;        ///< of the best level's score: the darkest such level is taken
  double leastLit = .03;     ///< share of the pixels above, against contours of highlights
  double oddsWeight = 2;     ///< of the mean log-odds of light that a level leaves in shadow
  double mostLit = 3;        ///< of a pixel for light, at most ...
  double mostUmbra = .5;     ///< ... and for umbra: it is told less surely

  static constexpr auto fields() {
    using T = ShadowThresholdTuning;
    return std::tuple{
        std::pair{"peak_reach", &T::peakReach},     std::pair{"length_bonus", &T::lengthBonus},
        std::pair{"area_bonus", &T::areaBonus},     std::pair{"full_ratio", &T::fullRatio},
        std::pair{"least_trust", &T::leastTrust},   std::pair{"usual_level", &T::usualLevel},
        std::pair{"spread_below", &T::spreadBelow}, std::pair{"spread_above", &T::spreadAbove},
        std::pair{"least_edge", &T::leastEdge},     std::pair{"smallest_unit", &T::smallestUnit},
        std::pair{"outside", &T::outside},          std::pair{"alike", &T::alike},
        std::pair{"least_lit", &T::leastLit},       std::pair{"odds_weight", &T::oddsWeight},
        std::pair{"most_lit", &T::mostLit},         std::pair{"most_umbra", &T::mostUmbra}};
  }
};

/// Of edges with a dark side (shadow_sides.h).
struct ShadowSidesTuning {
  float smoothing = 1.5F;  ///< units: standard deviation, of the ratio, before its curvature is taken
  float slopeReach = 3;    ///< units around a bend, over which the steepest slope is what the light falls by
  float flat = .1F;        ///< of the ratio itself: slopes that count as none
  float stepReach = 5;     ///< units: a step bends one way and, so near, the other way
  float stepShare = .4F;   ///< how much of a bend that takes back
  float rim = 2;           ///< units beside where the other lights tell nothing
  float leastBend = .45F;  ///< 0..1: of a bend with a dark side
  float leastStep = .4F;   ///< log, a pixel: of a step with one
  float stepStrength = .3F;  ///< of a step's sides; a bend's are at most 1
  float mostApart = .9F;     ///< log, a pixel: a penumbra's dark end is no better border than its middle
  float bendApart = .2F;     ///< bend that makes neighbours e times less of one kind
  float stepApart = .3F;     ///< log, a pixel: step that does
  float outlineApart = .4F;  ///< log, a pixel: step of the other lights that does

  static constexpr auto fields() {
    using T = ShadowSidesTuning;
    return std::tuple{std::pair{"smoothing", &T::smoothing},
                      std::pair{"slope_reach", &T::slopeReach},
                      std::pair{"flat", &T::flat},
                      std::pair{"step_reach", &T::stepReach},
                      std::pair{"step_share", &T::stepShare},
                      std::pair{"rim", &T::rim},
                      std::pair{"least_bend", &T::leastBend},
                      std::pair{"least_step", &T::leastStep},
                      std::pair{"step_strength", &T::stepStrength},
                      std::pair{"most_apart", &T::mostApart},
                      std::pair{"bend_apart", &T::bendApart},
                      std::pair{"step_apart", &T::stepApart},
                      std::pair{"outline_apart", &T::outlineApart}};
  }
};

/// Of the minimum cut (shadow_cut.h). Its costs are relative to each other.
struct ShadowCutTuning {
  float surelyShadow = .9F;  ///< log below the threshold
  float surelyLit = 1.7F;    ///< log above the threshold; in between, the edges decide
  float sure = 5;            ///< cost of a side that this rules out
  float levelCost = .1F;     ///< of a unit of the level's logarithm
  float middle = .25F;       ///< log above the threshold: as likely lit as in shadow
  float sideCost = .3F;      ///< of a side that edges speak against
  float markCost = 10;    ///< of a side that a mark denies: half its word outweighs what the level rules out
  float partingCost = 4;  ///< of neighbours on either side where there is no border
  float leastParting = .02F;  ///< the same where there is one
  float oddsPartingCost = 2;  ///< log-odds of one pixel: as partingCost, in the cut by odds
  float border = 1;     ///< units, a pixel at least: where two cuts part by less than twice this, they mean
                        ///< one border
  float unsure = 2.5F;  ///< log-odds of umbra, either way, that cannot be told ...
  float seen = .85F;    ///< ... where no more of the light than this is seen

  static constexpr auto fields() {
    using T = ShadowCutTuning;
    return std::tuple{std::pair{"surely_shadow", &T::surelyShadow},
                      std::pair{"surely_lit", &T::surelyLit},
                      std::pair{"sure", &T::sure},
                      std::pair{"level_cost", &T::levelCost},
                      std::pair{"middle", &T::middle},
                      std::pair{"side_cost", &T::sideCost},
                      std::pair{"mark_cost", &T::markCost},
                      std::pair{"parting_cost", &T::partingCost},
                      std::pair{"least_parting", &T::leastParting},
                      std::pair{"odds_parting_cost", &T::oddsPartingCost},
                      std::pair{"border", &T::border},
                      std::pair{"unsure", &T::unsure},
                      std::pair{"seen", &T::seen}};
  }
};

/// Of umbra, penumbra and lit (shadow_regions.h).
struct ShadowRegionsTuning {
  float guideScale = .2F;      ///< of the level, for the guided filter
  double guideEpsilon = 1e-4;  ///< of the guided filter, on that scale
  float softening = 2;         ///< units: how far a border is made soft
  float umbraOdds = .7F;       ///< log-odds of umbra that none of the light is seen with ...
  float litOdds = -1;          ///< ... and of lit that all of it is
  float umbra = .15F;          ///< visibility below which a pixel is umbra
  float lit = .9F;             ///< visibility above which it is lit

  static constexpr auto fields() {
    using T = ShadowRegionsTuning;
    return std::tuple{std::pair{"guide_scale", &T::guideScale},
                      std::pair{"guide_epsilon", &T::guideEpsilon},
                      std::pair{"softening", &T::softening},
                      std::pair{"umbra_odds", &T::umbraOdds},
                      std::pair{"lit_odds", &T::litOdds},
                      std::pair{"umbra", &T::umbra},
                      std::pair{"lit", &T::lit}};
  }
};

/// All of them.
struct ShadowTuning {
  ShadowEvidenceTuning evidence;
  OtherLightsTuning others;
  ShadowThresholdTuning threshold;
  ShadowSidesTuning sides;
  ShadowMarkTuning marks;
  ShadowCutTuning cut;
  ShadowRegionsTuning regions;
  FadingLightTuning fading;
  PenumbraTuning penumbra;
  ShadowFloorTuning floor;
  ShadowFillTuning fill;

  static constexpr auto fields() {
    using T = ShadowTuning;
    return std::tuple{std::pair{"evidence", &T::evidence},
                      std::pair{"others", &T::others},
                      std::pair{"threshold", &T::threshold},
                      std::pair{"sides", &T::sides},
                      std::pair{"marks", &T::marks},
                      std::pair{"cut", &T::cut},
                      std::pair{"regions", &T::regions},
                      std::pair{"fading", &T::fading},
                      std::pair{"penumbra", &T::penumbra},
                      std::pair{"floor", &T::floor},
                      std::pair{"fill", &T::fill}};
  }
};

}  // namespace swaplight
