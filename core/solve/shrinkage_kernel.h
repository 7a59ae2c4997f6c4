#pragma once

#include "core/solve/shrinkage.h"

namespace swaplight {

/// What the kernel of Shrinkage gives for a run; any pointer may be null.
struct ShrinkageRun {
  float* logEvidence[ShrinkagePrior::kScales] = {};  ///< up to a constant a pixel
  SolvedRun* solved = nullptr;                       ///< all planes but the residual
  float* notMatte = nullptr;
};

/// All pixels of a run, whose matte fit is given; planes padded to kLanes. `odds` may be null.
void shrinkRun(const Shrinkage::Plan& plan, const PixelRun& in, const MatteRun& matte, const float* odds,
               const ShrinkageRun& out);

}  // namespace swaplight
