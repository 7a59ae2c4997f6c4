#pragma once

#include "core/simd/plane_arena.h"
#include "core/solve/model/pixel_run.h"

namespace swaplight {

/// Planes to solve `count` pixels into: contributions, residual and sigma. No beta.
class SolvedPlanes {
 public:
  SolvedPlanes(int lights, size_t count) : m_arena(count, size_t(3 * lights + 2)) {
    for (int i = 0; i < lights; ++i)
      for (int c = 0; c < 3; ++c) m_run.contribution[i][c] = m_arena.take();
    m_run.residual = m_arena.take();
    m_run.sigma = m_arena.take();
  }
  [[nodiscard]] const SolvedRun& run() const { return m_run; }

 private:
  PlaneArena m_arena;
  SolvedRun m_run;
};

}  // namespace swaplight
