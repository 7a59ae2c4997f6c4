#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/solve/model/packed_run.h"
#include "core/solve/model/solved_planes.h"

namespace swaplight {

/// Some pixels of a run, gathered side by side so that an estimator can run over them, and planes for its
/// answer, which is scattered to where they came from.
class PixelBatch {
 public:
  PixelBatch(const PixelRun& from, std::vector<int> index, int shots, int lights)
      : m_index(std::move(index)),
        m_lights(lights),
        m_packed(shots, m_index.size()),
        m_solved(lights, m_index.size()) {
    m_packed.add(from, m_index);
  }
  [[nodiscard]] const PixelRun& in() const { return m_packed.run(); }
  [[nodiscard]] const SolvedRun& out() const { return m_solved.run(); }
  /// Where each pixel lies in the run.
  [[nodiscard]] std::span<const int> index() const { return m_index; }

  /// The batch's pixels of a plane of the run.
  void gather(const float* from, float* to) const {
    for (size_t j = 0; j < m_index.size(); ++j) to[j] = from[m_index[j]];
  }
  void scatter(const float* from, float* to) const {
    for (size_t j = 0; j < m_index.size(); ++j) to[m_index[j]] = from[j];
  }
  /// The answer, but for planes that are not wanted (null).
  void scatter(const SolvedRun& to) const {
    for (int i = 0; i < m_lights; ++i)
      for (int c = 0; c < 3; ++c) scatter(out().contribution[i][c], to.contribution[i][c]);
    if (to.residual) scatter(out().residual, to.residual);
    if (to.sigma) scatter(out().sigma, to.sigma);
  }

 private:
  std::vector<int> m_index;
  int m_lights;
  PackedRun m_packed;
  SolvedPlanes m_solved;
};

}  // namespace swaplight
