#pragma once

#include <tuple>
#include <utility>

#include "core/solve/calibration/calibration_tuning.h"

namespace swaplight {

// What steers model `auto`. Where no derivation is given, a value was chosen on the hard cases with one seed
// (swaplight bench --hard-cases); docs/accuracy.md, What the constants cost, has them changed on another
// (scripts/make_ablation solve --only auto.).

/// Of beta pooled with its neighbours (share_pooling.h): once with those beside it, once with those around.
struct PoolingTuning {
  float nearChi2 = 9;       ///< squared difference of beta over its variance that rejects: 3 sigma
  float farChi2 = 4;        ///< the same the second time: 2 sigma, less noise is left
  float nearHidden = .25F;  ///< fraction of the variance that differences below the noise may hide
  float farHidden = .4F;    ///< the same the second time: of neighbours that lie further away
  float farOverlap = 3.7F;  ///< variance of a mean of pooled neighbours over that of independent ones
  float guideStep = .1F;    ///< of a bright part of the set: the step of the guide that counts as an edge
  double guideLevel = .95;  ///< quantile of the guide that a bright part has

  static constexpr auto fields() {
    using T = PoolingTuning;
    return std::tuple{std::pair{"near_chi2", &T::nearChi2},     std::pair{"far_chi2", &T::farChi2},
                      std::pair{"near_hidden", &T::nearHidden}, std::pair{"far_hidden", &T::farHidden},
                      std::pair{"far_overlap", &T::farOverlap}, std::pair{"guide_step", &T::guideStep},
                      std::pair{"guide_level", &T::guideLevel}};
  }
};

/// Of what pixels need beyond the matte model (shrinkage.h).
struct ShrinkageTuning {
  float gate = 1.5F;      ///< standard deviations of chi-square above its mean: below, a pixel is matte
  float whiteness = .8F;  ///< correlation of its channels, 0..1: gloss is mostly white
  /// Its standard deviations (tau), over the brightness of the set. Three lose nothing against six.
  float smallScale = .02F, middleScale = .1F, largeScale = .6F;
  double brightLevel = .99;   ///< quantile of reflectance that is that brightness
  float leastWeight = 1e-5F;  ///< how often a scale is needed, at least: none is ever ruled out
  int sample = 20000;         ///< pixels that the prior is learnt from
  int rounds = 15;            ///< of expectation-maximisation

  static constexpr auto fields() {
    using T = ShrinkageTuning;
    return std::tuple{std::pair{"gate", &T::gate},
                      std::pair{"whiteness", &T::whiteness},
                      std::pair{"small_scale", &T::smallScale},
                      std::pair{"middle_scale", &T::middleScale},
                      std::pair{"large_scale", &T::largeScale},
                      std::pair{"bright_level", &T::brightLevel},
                      std::pair{"least_weight", &T::leastWeight},
                      std::pair{"sample", &T::sample},
                      std::pair{"rounds", &T::rounds}};
  }
};

/// Of the prior odds of a pixel from its neighbours (neighbourhood.h).
struct NeighbourhoodTuning {
  float limit = 3.5F;  ///< standard deviations of chi-square above its mean that count as a failure
  float temper = .5F;  ///< weight of the whole set's failures beside those of the window
  int radius = 3;      ///< pixels, of the window

  static constexpr auto fields() {
    using T = NeighbourhoodTuning;
    return std::tuple{std::pair{"limit", &T::limit}, std::pair{"temper", &T::temper},
                      std::pair{"radius", &T::radius}};
  }
};

/// Of pixels that are clipped in too many shots (clipped_light.h).
struct ClippedLightTuning {
  double modelError = .03;  ///< part of a value by which what is not clipped may miss the model
  double spread = .5;       ///< of the pixel's light: how far it strays from its neighbours' proportions

  static constexpr auto fields() {
    using T = ClippedLightTuning;
    return std::tuple{std::pair{"model_error", &T::modelError}, std::pair{"spread", &T::spread}};
  }
};

/// Of what the photographs show beyond all that (local_evidence.h).
struct LocalEvidenceTuning {
  int radius = 6;             ///< pixels, of the window
  double leastSeen = .2;      ///< of the best seen direction: with one that is seen less nothing is moved
  double unknownNoise = 1.1;  ///< noise may be so many times what it is taken for
  double unknownWeak = .1;    ///< and this part more in a direction that is seen half as well
  double smallColorError =
      .01;  ///< an uncertainty of the colours that is smaller was hardly seen, and counts less
  double leastMoved = .005;  ///< of the variance of noise; below, the set shows nothing
  int windows = 400;         ///< that say so

  static constexpr auto fields() {
    using T = LocalEvidenceTuning;
    return std::tuple{std::pair{"radius", &T::radius},
                      std::pair{"least_seen", &T::leastSeen},
                      std::pair{"unknown_noise", &T::unknownNoise},
                      std::pair{"unknown_weak", &T::unknownWeak},
                      std::pair{"small_color_error", &T::smallColorError},
                      std::pair{"least_moved", &T::leastMoved},
                      std::pair{"windows", &T::windows}};
  }
};

struct AutoTuning {
  EdgeNoiseTuning edges;
  PoolingTuning pooling;
  ShrinkageTuning shrinkage;
  NeighbourhoodTuning neighbourhood;
  LocalEvidenceTuning evidence;
  ClippedLightTuning clipped;

  static constexpr auto fields() {
    using T = AutoTuning;
    return std::tuple{std::pair{"edges", &T::edges},         std::pair{"pooling", &T::pooling},
                      std::pair{"shrinkage", &T::shrinkage}, std::pair{"neighbourhood", &T::neighbourhood},
                      std::pair{"evidence", &T::evidence},   std::pair{"clipped", &T::clipped}};
  }
};

}  // namespace swaplight
