#pragma once

#include <vector>

#include "core/set/solved_set.h"

namespace swaplight {

/// What the second stream of solveAuto needs of the first, a plane each, in the memory of the answer: no
/// plane of a large set is kept twice. Each is part of an answer that the second stream writes run by run,
/// after it has read that run of the scratch for the last time.
struct AutoScratch {
  explicit AutoScratch(SolvedSet& set);

  ImageSpan misfit;         ///< chi-square of the matte fit
  ImageSpan shareVariance;  ///< of beta; pooled from there on
  ImageSpan odds;           ///< localOdds
  ImageSpan edgeFactor;     ///< edgeNoiseFactor
  // With two lights and more; else empty.
  ImageSpan guide;                    ///< of pooling
  std::vector<ImageSpan> nearShares;  ///< of the first of the two poolings
  ImageSpan nearVariance;             ///< likewise
};

}  // namespace swaplight
