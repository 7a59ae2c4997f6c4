#pragma once

#include <tuple>
#include <utility>

namespace swaplight {

// Of ShadowTuning: what steers penumbras and filled shadows, after shadow has been divided from light.

/// Of light that fades out without a shadow (fading_light.h).
struct FadingLightTuning {
  double near = 3;       ///< units: mean of the ratio beside a pixel (two pixels at least)
  double wide = 5;       ///< its radius over that: mean of what is around
  double gone = .65;     ///< of the mean around: the light has faded
  double goneRamp = .2;  ///< over how much more it is as it is around
  double castFrom = .4;  ///< of the same, continued: a shadow nearby is cast
  double castRamp = .3;  ///< over how much more that becomes certain

  static constexpr auto fields() {
    using T = FadingLightTuning;
    return std::tuple{std::pair{"near", &T::near},          std::pair{"wide", &T::wide},
                      std::pair{"gone", &T::gone},          std::pair{"gone_ramp", &T::goneRamp},
                      std::pair{"cast_from", &T::castFrom}, std::pair{"cast_ramp", &T::castRamp}};
  }
};

/// Of exact penumbras (penumbra.h). Slopes are logarithms a pixel.
struct PenumbraTuning {
  float calm = .015F;      ///< slope of the ratio: less is no edge of a shadow
  float smoothing = 1.2F;  ///< units: standard deviation, of the ratio, before its slope is taken
  float rim = 2;           ///< units beside a shadow that are not taken for fully lit
  float reach = 45;        ///< units from a shadow to the end of its penumbra
  float window = 6;        ///< units around a pixel over which slopes are added up
  float pooling = 12;      ///< units around a pixel over which edges are of one kind
  float sharp = .3F;       ///< slope of the other lights that belongs to an outline or a print
  float edgeLow = .1F;     ///< visibility from which on a pixel belongs to an edge
  float edgeHigh = .95F;   ///< and up to which
  float fewest = 2.5F;     ///< pixels of an edge in the window, to say anything
  float cast = .2F;       ///< other lights' slope (log) over this light's (visibility): less is a cast shadow
  float castRamp = .08F;  ///< over how much less that becomes certain
  float turns = .3F;      ///< the same ratio: more is a surface that turns away
  float turnsRamp = .15F;    ///< over how much more that becomes certain
  float leastCast = .1F;     ///< share of the edge around a pixel that is cast
  float leastTurning = .3F;  ///< share that turns away
  float leastRamp = .2F;     ///< over how much more either becomes certain
  float ends = .05F;        ///< visibility, as divided, at which a surface that turns away has lost the light
  float endsRamp = .35F;    ///< over how much more it sees all of it
  int othersRim = 2;        ///< pixels beside the other lights' own shadows that tell nothing
  float fadeDoubt = .3F;    ///< how much less a surface turns away where the light does not fade
  float mostBounced = .3F;  ///< of what would arrive without the shadow
  float fullyDivided = .95F;  ///< visibility, as divided, of pixels surely lit

  static constexpr auto fields() {
    using T = PenumbraTuning;
    return std::tuple{std::pair{"calm", &T::calm},
                      std::pair{"smoothing", &T::smoothing},
                      std::pair{"rim", &T::rim},
                      std::pair{"reach", &T::reach},
                      std::pair{"window", &T::window},
                      std::pair{"pooling", &T::pooling},
                      std::pair{"sharp", &T::sharp},
                      std::pair{"edge_low", &T::edgeLow},
                      std::pair{"edge_high", &T::edgeHigh},
                      std::pair{"fewest", &T::fewest},
                      std::pair{"cast", &T::cast},
                      std::pair{"cast_ramp", &T::castRamp},
                      std::pair{"turns", &T::turns},
                      std::pair{"turns_ramp", &T::turnsRamp},
                      std::pair{"least_cast", &T::leastCast},
                      std::pair{"least_turning", &T::leastTurning},
                      std::pair{"least_ramp", &T::leastRamp},
                      std::pair{"ends", &T::ends},
                      std::pair{"ends_ramp", &T::endsRamp},
                      std::pair{"others_rim", &T::othersRim},
                      std::pair{"fade_doubt", &T::fadeDoubt},
                      std::pair{"most_bounced", &T::mostBounced},
                      std::pair{"fully_divided", &T::fullyDivided}};
  }
};

/// Of what a light's own shadows hold of it (shadow_floor.h).
struct ShadowFloorTuning {
  float inside = .02F;          ///< visibility, as divided, below which a pixel lies inside a shadow
  float depth = 8;              ///< units from there to the shadow's edge
  int fewest = 100;             ///< pixels inside, to say anything
  float reach = 20;             ///< units over which the floor is the mean of what is around
  float overall = .02F;         ///< weight of the whole picture's floor
  float spreadOfMiddle = 1.5F;  ///< standard deviation over the median of absolute deviations; 1.48 if normal
  double high = .9;             ///< share of the pixels inside that are below `high`
  float floors = 2.5F;          ///< a light reaches a surface above so many floors
  float spreads = 2.5F;         ///< and so many standard deviations
  float share = .004F;          ///< and this share of what would arrive without a shadow
  float aboveHigh = 1.2F;       ///< and `high` by this factor
  float ramp = .5F;             ///< over how much more of that it becomes certain
  float black = .006F;      ///< of what would arrive without them: shadows this dark are black but for noise
  float blackRamp = .006F;  ///< over how much more they no longer are
  float step = .12F;        ///< of the unshadowed ratio, a pixel: the outline of a thing
  float stepWidth = 3.5F;   ///< units around one that it tells nothing about

  static constexpr auto fields() {
    using T = ShadowFloorTuning;
    return std::tuple{std::pair{"inside", &T::inside},
                      std::pair{"depth", &T::depth},
                      std::pair{"fewest", &T::fewest},
                      std::pair{"reach", &T::reach},
                      std::pair{"overall", &T::overall},
                      std::pair{"spread_of_middle", &T::spreadOfMiddle},
                      std::pair{"high", &T::high},
                      std::pair{"floors", &T::floors},
                      std::pair{"spreads", &T::spreads},
                      std::pair{"share", &T::share},
                      std::pair{"above_high", &T::aboveHigh},
                      std::pair{"ramp", &T::ramp},
                      std::pair{"black", &T::black},
                      std::pair{"black_ramp", &T::blackRamp},
                      std::pair{"step", &T::step},
                      std::pair{"step_width", &T::stepWidth}};
  }
};

/// Of filled shadows (shadow_fill.h).
struct ShadowFillTuning {
  float rim = 2;             ///< units beside shadows that are not continued: the faint end of penumbras
  float sure = .7F;          ///< visibility from which on pixels are continued, not filled
  float allSeen = .9F;       ///< visibility from which on such pixels see all of the light
  float leastOfMean = .93F;  ///< of the ratio around a pixel: less is not fully lit
  float pictureEdge = .5F;   ///< log step of the whole picture that a contribution is not continued over
  float barelySeen = .1F;    ///< visibility from which on bounced light counts as direct more and more
  float fullySeen = .7F;     ///< visibility from which on the whole contribution counts as direct
  float reached = .05F;      ///< visibility beyond the end of shading that falls off
  float leastGrey = 1e-4F;   ///< of white

  static constexpr auto fields() {
    using T = ShadowFillTuning;
    return std::tuple{std::pair{"rim", &T::rim},
                      std::pair{"sure", &T::sure},
                      std::pair{"all_seen", &T::allSeen},
                      std::pair{"least_of_mean", &T::leastOfMean},
                      std::pair{"picture_edge", &T::pictureEdge},
                      std::pair{"barely_seen", &T::barelySeen},
                      std::pair{"fully_seen", &T::fullySeen},
                      std::pair{"reached", &T::reached},
                      std::pair{"least_grey", &T::leastGrey}};
  }
};

}  // namespace swaplight
