#pragma once

#include "core/solve/auto/auto_tuning.h"
#include "core/solve/calibration/calibration_tuning.h"
#include "core/solve/registration/registration_tuning.h"

namespace swaplight {

/// The constants that steer a solve, beside what the person asks for (SolveOptions). Every program uses them
/// as they are; tests/bench/ablation_bench.cpp measures what changing one costs.
struct SolveTuning {
  AutoTuning automatic;
  NoiseCalibrationTuning noise;
  ResidualNoiseTuning ownNoise;
  ColorFitTuning colors;
  SwappedColorTuning swapped;
  ColorEvidenceTuning colorEvidence;
  AmbientTuning ambient;
  MotionTuning motion;
  float tooDarkSigma = .25F;  ///< quality.sigma above which a pixel's beta is its neighbours'
  double notMoved = .02;  ///< part of the misfit's variance below which no motion explains misfit at edges

  static constexpr auto fields() {
    using T = SolveTuning;
    return std::tuple{std::pair{"auto", &T::automatic},
                      std::pair{"noise", &T::noise},
                      std::pair{"own_noise", &T::ownNoise},
                      std::pair{"colors", &T::colors},
                      std::pair{"swapped", &T::swapped},
                      std::pair{"color_evidence", &T::colorEvidence},
                      std::pair{"ambient", &T::ambient},
                      std::pair{"motion", &T::motion},
                      std::pair{"too_dark_sigma", &T::tooDarkSigma},
                      std::pair{"not_moved", &T::notMoved}};
  }
};

}  // namespace swaplight
