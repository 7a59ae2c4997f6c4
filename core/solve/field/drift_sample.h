#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/simd/plane_arena.h"
#include "core/solve/causes/cause_context.h"
#include "core/solve/causes/misfit_sample.h"
#include "core/solve/estimators/run_scratch.h"
#include "core/solve/field/field_tuning.h"
#include "core/solve/field/lamp_drift.h"

namespace swaplight {

/// The bright pixels of photographs, and their matte fit as if the lamps were even.
class DriftSample {
 public:
  /// `context` lives as long.
  DriftSample(const CauseContext& context, const FieldTuning& tuning);

  /// Fits the values less what `drift` makes of them: y + sum_i l_i (1 - d_i) beta_i rho, with the fit before
  /// this one, which is nearer each time.
  void fit(const LampDrift& drift);

  [[nodiscard]] int count() const { return m_run.count; }
  [[nodiscard]] int lights() const { return m_context.estimator.lighting.lights; }
  [[nodiscard]] const LightingMatrix& lighting() const { return m_context.estimator.lighting; }
  [[nodiscard]] const LampDrift::Terms& terms(int p) const { return m_terms[size_t(p)]; }
  [[nodiscard]] int tile(int p) const { return m_tile[size_t(p)]; }  ///< 0 .. tiles^2 - 1
  [[nodiscard]] double share(int p, int light) const { return double(m_fit.run().share[light][p]); }
  /// log rho less the mean over the channels.
  [[nodiscard]] std::array<double, 3> hue(int p) const;
  /// Variance of hue(), the mean of the channels, by the noise of the pixel.
  [[nodiscard]] double hueVariance(int p) const;
  [[nodiscard]] PixelMisfit misfit(int p) const;
  /// Pixels so far apart across or down that their colours are compared.
  [[nodiscard]] const std::vector<std::pair<int, int>>& neighbours() const { return m_neighbours; }

 private:
  void findNeighbours(int width, int height);
  [[nodiscard]] double predicted(int shot, int channel, int p) const;

  const CauseContext& m_context;
  const FieldTuning& m_tuning;
  PlacedPixels m_pixels;
  PlaneArena m_arena;
  PixelRun m_run;  ///< evened
  std::vector<float*> m_planes;
  MatteScratch m_fit;
  std::vector<LampDrift::Terms> m_terms;
  std::vector<int> m_tile;
  std::vector<std::pair<int, int>> m_neighbours;
};

}  // namespace swaplight
