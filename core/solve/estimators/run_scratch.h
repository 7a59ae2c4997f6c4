#pragma once

#include "core/simd/plane_arena.h"
#include "core/solve/estimators/matte_fit.h"

namespace swaplight {

/// Room for the matte fit of a run.
class MatteScratch {
 public:
  MatteScratch(int lights, int count);
  [[nodiscard]] const MatteRun& run() const { return m_run; }

  /// beta from contributions; equal shares where there is no light.
  void readShares(int lights, int count, const SolvedRun& from) const;

 private:
  PlaneArena m_arena;
  MatteRun m_run;
};

/// T = beta rho.
void writeContributions(const MatteRun& fit, int lights, int count, const SolvedRun& out);
/// residual = sqrt(chi-square / freedom), sigma = sqrt(variance).
void writeQuality(const MatteRun& fit, int freedom, int count, const SolvedRun& out);

}  // namespace swaplight
