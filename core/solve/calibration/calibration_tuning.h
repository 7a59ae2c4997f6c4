#pragma once

#include <tuple>
#include <utility>

namespace swaplight {

// What steers the estimates of noise, light colours and ambient light. What changing a value costs:
// scripts/make_ablation solve.

/// Of noise held against what the matte model leaves (noise_calibration.h).
struct NoiseCalibrationTuning {
  int sample = 16000;            ///< pixels
  double largestFactor = 10;     ///< of the variance; more is gloss and bounced light
  double smallestFactor = 1e-4;  ///< the same where nothing is flat: texture was taken for noise
  double nothingFlat = .5;       ///< factor that no bin may exceed for that

  static constexpr auto fields() {
    using T = NoiseCalibrationTuning;
    return std::tuple{std::pair{"sample", &T::sample}, std::pair{"largest_factor", &T::largestFactor},
                      std::pair{"smallest_factor", &T::smallestFactor},
                      std::pair{"nothing_flat", &T::nothingFlat}};
  }
};

/// Of noise in what the matte model leaves (residual_noise.h).
struct ResidualNoiseTuning {
  int blocks = 900;           ///< of 8 x 8 pixels that are looked at
  int mostBins = 8;           ///< of brightness
  int fewest = 40;            ///< blocks a bin
  double mostCorrelated = 9;  ///< variance of a mean of 2 x 2 over that of independent noise

  static constexpr auto fields() {
    using T = ResidualNoiseTuning;
    return std::tuple{std::pair{"blocks", &T::blocks}, std::pair{"most_bins", &T::mostBins},
                      std::pair{"fewest", &T::fewest}, std::pair{"most_correlated", &T::mostCorrelated}};
  }
};

/// Of shots that do not lie exactly on one another (edge_noise.h).
struct EdgeNoiseTuning {
  int minSample = 2000;         ///< pixels
  float minMisfitRatio = 1.5F;  ///< median misfit at the edges over that of the flatter half
  float maxFlatMisfit = 3.5F;   ///< of what noise explains: a moved camera spoils flat parts no more
  float minShift2 = .002F;      ///< pixel^2: what is closer together did not move
  /// Of the squared shift that the median pixel speaks of. An edge is sharper than its surroundings' mean:
  /// the worst pixels would count as gloss.
  float tailFactor = 16;
  /// Pixels: what shots that were moved onto one another are taken to lie apart by, at least.
  float resampled = .18F;

  static constexpr auto fields() {
    using T = EdgeNoiseTuning;
    return std::tuple{
        std::pair{"min_sample", &T::minSample},          std::pair{"min_misfit_ratio", &T::minMisfitRatio},
        std::pair{"max_flat_misfit", &T::maxFlatMisfit}, std::pair{"min_shift2", &T::minShift2},
        std::pair{"tail_factor", &T::tailFactor},        std::pair{"resampled", &T::resampled}};
  }
};

/// Of light colours fitted to the photographs, and of how far they are trusted (color_fit.h).
struct ColorFitTuning {
  int sample = 6000;             ///< pixels at most
  double brightShare = .4;       ///< of the pixels, the brighter ones, that are used
  double baseUncertainty = .01;  ///< relative standard error of the matte model itself
  int robustRounds = 6;          ///< of reweighting
  /// Standard error of the colours over the systematic misfit: beta and reflectance absorb half of a colour's
  /// error. Measured on captures with known errors.
  double absorbed = 2.5;
  double systematicFloor = .006;  ///< misfit that captures with exact colours have
  double noisyError = 1e-3;       ///< relative noise of a mid-tone above which little is seen of the colours
  float noisyUncertainty = .05F;  ///< what is assumed of them then where nothing says: gels are known to that

  static constexpr auto fields() {
    using T = ColorFitTuning;
    return std::tuple{std::pair{"sample", &T::sample},
                      std::pair{"bright_share", &T::brightShare},
                      std::pair{"base_uncertainty", &T::baseUncertainty},
                      std::pair{"robust_rounds", &T::robustRounds},
                      std::pair{"absorbed", &T::absorbed},
                      std::pair{"systematic_floor", &T::systematicFloor},
                      std::pair{"noisy_error", &T::noisyError},
                      std::pair{"noisy_uncertainty", &T::noisyUncertainty}};
  }
};

/// Of an unknown colour that has changed places with a known one (swapped_color.h).
struct SwappedColorTuning {
  int sample = 120000;         ///< pixels
  int together = 4;            ///< neighbours whose mean is taken
  int minGroups = 50;          ///< that can be used
  double minSignal = 6;        ///< of their light, in standard deviations
  double systematic = .01;     ///< error of a contrast that no noise explains: gels that are not quite alike
  int rounds = 20;             ///< of the robust fit
  double deviations = 1.5;     ///< that noise may have added to an extreme contrast
  double kindOfSurface = .12;  ///< step of ln(light) less its mean over the channels
  double extreme = .98;        ///< of a kind's groups; the others beyond are taken for gloss, movement, drift
  int minOfKind = 150;         ///< groups of a kind that has a say
  double kindsDiffer =
      .55;                 ///< a camera may see a gel this much less strongly on one surface than on another
  double mostKinds = .7;   ///< of the kinds left, by their size: the scale of so many is below the one taken
  double scaleError = .1;  ///< of |l - m| / (l + m), by surfaces that see a gel otherwise than others do
  double bareLamp = .04;   ///< RMS distance of ln m from white below which the lamp had no gel
  double minContrast = .02;  ///< of the lamps: below, the photographs are taken for the same
  double farthest = .95;     ///< |l - m| / (l + m): no gel takes more than 97 % from another's channel

  static constexpr auto fields() {
    using T = SwappedColorTuning;
    return std::tuple{std::pair{"sample", &T::sample},
                      std::pair{"together", &T::together},
                      std::pair{"min_groups", &T::minGroups},
                      std::pair{"min_signal", &T::minSignal},
                      std::pair{"systematic", &T::systematic},
                      std::pair{"rounds", &T::rounds},
                      std::pair{"deviations", &T::deviations},
                      std::pair{"kind_of_surface", &T::kindOfSurface},
                      std::pair{"extreme", &T::extreme},
                      std::pair{"min_of_kind", &T::minOfKind},
                      std::pair{"kinds_differ", &T::kindsDiffer},
                      std::pair{"most_kinds", &T::mostKinds},
                      std::pair{"scale_error", &T::scaleError},
                      std::pair{"bare_lamp", &T::bareLamp},
                      std::pair{"min_contrast", &T::minContrast},
                      std::pair{"farthest", &T::farthest}};
  }
};

/// Of how wrong the colours are where the noise is not told (color_evidence.h).
struct ColorEvidenceTuning {
  int blocks = 900;             ///< of 8 x 8 pixels that are looked at
  int fewest = 50;              ///< bright ones; with fewer nothing is said
  double bright = .1;           ///< of the 95th percentile of brightness: what is bright
  double lowest = .02;          ///< quantile of the blocks that stands for where a light is blocked
  double quiet = .2;            ///< quantile of the blocks' misfit that wrong colours alone may have
  double lowestOfNoise = 2.05;  ///< standard errors by which noise lowers that quantile at most
  double unseen = .005;         ///< error that the fit of the colours does not show
  double alone = .1;            ///< how often the colours' error is all that their fit shows
  double level = .1;            ///< signal at which the misfit is held against what the colours explain
  double unmeasured = .5;       ///< part of the pixels' own noise; where the misfit lies that far below it,
                                ///< nothing was there to measure the noise by
  double visibleFreedom = 4;    ///< directions of colour errors that the matte model shows, at least
  double smallest = .002, largest = .15;  ///< standard errors that are weighed

  static constexpr auto fields() {
    using T = ColorEvidenceTuning;
    return std::tuple{std::pair{"blocks", &T::blocks},
                      std::pair{"fewest", &T::fewest},
                      std::pair{"bright", &T::bright},
                      std::pair{"lowest", &T::lowest},
                      std::pair{"quiet", &T::quiet},
                      std::pair{"unseen", &T::unseen},
                      std::pair{"alone", &T::alone},
                      std::pair{"level", &T::level},
                      std::pair{"unmeasured", &T::unmeasured},
                      std::pair{"visible_freedom", &T::visibleFreedom},
                      std::pair{"lowest_of_noise", &T::lowestOfNoise},
                      std::pair{"smallest", &T::smallest},
                      std::pair{"largest", &T::largest}};
  }
};

/// Of the ambient light's colour (ambient_light.h).
struct AmbientTuning {
  int sample = 20000;       ///< pixels
  int minPixels = 200;      ///< that see enough of the ambient light; else it is taken for white
  float minSignal = 5;      ///< ambient light over its standard error, in each channel
  float minOthers = .02F;   ///< part of the light that is of the lights, in each channel
  float maxSaturation = 3;  ///< factor between its channels and their mean that is believed

  static constexpr auto fields() {
    using T = AmbientTuning;
    return std::tuple{std::pair{"sample", &T::sample}, std::pair{"min_pixels", &T::minPixels},
                      std::pair{"min_signal", &T::minSignal}, std::pair{"min_others", &T::minOthers},
                      std::pair{"max_saturation", &T::maxSaturation}};
  }
};

}  // namespace swaplight
