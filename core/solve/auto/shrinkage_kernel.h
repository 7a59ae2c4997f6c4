#pragma once

#include <array>
#include <vector>

#include "core/simd/simd.h"
#include "core/solve/estimators/matte_kernel.h"

namespace swaplight {

/// What the set says of its surfaces: learnt from a sample of its pixels before they are solved.
struct ShrinkagePrior {
  static constexpr int kScales = 4;
  /// tau: standard deviation of what is not matte, linear light; the first is 0.
  std::array<float, kScales> scale{};
  /// How often each of them is needed; sums to 1.
  std::array<float, kScales> weight{};
};

/// Constants of the capture, laid out for the kernel.
struct ShrinkagePlan {
  int lights = 0, shots = 0;
  float constant = 0, linear = 0, square = 0;  ///< noise model
  std::array<float, 3> unseen{};               ///< 1: a channel that no light has
  std::vector<float> color;                    ///< [k][c][i]
  std::vector<float> shape;                    ///< [k][c]: 1 / D
  std::vector<float> toModes;                  ///< [m][k][c]: U' D^-1/2
  std::vector<float> singular;                 ///< [m]
  std::vector<float> modes;                    ///< [m][i][c]: W'
  std::array<float, 9> whiten{};               ///< P^-1/2 of a light's channels
  std::vector<float> fromModes;                ///< [i][c][m]: P^1/2 W
  std::vector<float> greyPower;                ///< [m]: mean over lights of the squared grey part of a mode
  ShrinkagePrior prior;
};

/// What the kernel of Shrinkage gives for a run; any pointer may be null.
struct ShrinkageRun {
  float* logEvidence[ShrinkagePrior::kScales] = {};  ///< up to a constant a pixel
  SolvedRun* solved = nullptr;                       ///< all planes but the residual
  float* notMatte = nullptr;
};

/// All pixels of a run, whose matte fit is given; planes padded to kMostLanes. `odds` and `noise`, a factor
/// of the noise model's variance, may be null.
SWAPLIGHT_DECLARE_KERNEL(shrinkRun, const ShrinkagePlan& plan, const PixelRun& in, const MatteRun& matte,
                         const float* odds, const float* noise, const ShrinkageRun& out)

}  // namespace swaplight
