#include "core/solve/field/drift_sample.h"

#include <algorithm>
#include <cmath>

namespace swaplight {
namespace {

constexpr double kLeastReflectance = 1e-6;

PlacedPixels allBright(const CauseContext& context, const FieldTuning& tuning) {
  CauseTuning bright;
  bright.bright = tuning.darkest;
  return brightPixels(context.signal, context.estimator.lighting.shots, int(context.signal.pixelCount()),
                      bright);
}

}  // namespace

DriftSample::DriftSample(const CauseContext& context, const FieldTuning& tuning)
    : m_context(context),
      m_tuning(tuning),
      m_pixels(allBright(context, tuning)),
      m_arena(size_t(std::max(m_pixels.values.run().count, 1)), size_t(3 * context.estimator.lighting.shots)),
      m_fit(context.estimator.lighting.lights, std::max(m_pixels.values.run().count, 1)) {
  m_run.count = m_pixels.values.run().count;
  for (int k = 0; k < lighting().shots; ++k)
    for (int c = 0; c < 3; ++c) {
      m_planes.push_back(m_arena.take(0));
      m_run.signal[k][c] = m_planes.back();
      std::copy_n(m_pixels.values.run().signal[k][c], m_run.count, m_planes.back());
    }
  const int width = context.signal.pixels().width(), height = context.signal.pixels().height();
  for (const size_t place : m_pixels.places) {
    const double x = double(place % size_t(width)) + .5, y = double(place / size_t(width)) + .5;
    m_terms.push_back(LampDrift::terms(2 * x / width - 1, 2 * y / height - 1));
    m_tile.push_back(int(x / width * tuning.tiles) + tuning.tiles * int(y / height * tuning.tiles));
  }
  findNeighbours(width, height);
  if (m_run.count > 0) MatteFit(m_context.estimator).fit(m_run, m_fit.run());
}

void DriftSample::findNeighbours(int width, int height) {
  std::vector<int> at(size_t(width) * size_t(height), -1);
  for (size_t p = 0; p < m_pixels.places.size(); ++p) at[m_pixels.places[p]] = int(p);
  const int step = std::max(1, std::max(width, height) / m_tuning.neighbours);
  for (size_t p = 0; p < m_pixels.places.size(); ++p) {
    const size_t place = m_pixels.places[p];
    if (int(place % size_t(width)) + step < width)
      if (const int other = at[place + size_t(step)]; other >= 0) m_neighbours.emplace_back(int(p), other);
    if (int(place / size_t(width)) + step < height)
      if (const int other = at[place + size_t(step) * size_t(width)]; other >= 0)
        m_neighbours.emplace_back(int(p), other);
  }
}

void DriftSample::fit(const LampDrift& drift) {
  const PixelRun& taken = m_pixels.values.run();
  const MatteRun& fit = m_fit.run();
  for (int p = 0; p < m_run.count; ++p) {
    for (size_t row = 0; row < m_planes.size(); ++row) m_planes[row][p] = taken.signal[row / 3][row % 3][p];
    for (int i = 0; i < lights(); ++i) {
      const std::array<double, 3> factor = drift.factor(i, terms(p));
      for (size_t row = 0; row < m_planes.size(); ++row) {
        const int c = int(row % 3);
        m_planes[row][p] += lighting().color(int(row / 3), i)[c] * float(1 - factor[row % 3]) *
                            fit.share[i][p] * fit.reflectance[c][p];
      }
    }
  }
  if (m_run.count > 0) MatteFit(m_context.estimator).fit(m_run, fit);
}

double DriftSample::predicted(int shot, int channel, int p) const {
  double sum = 0;
  for (int i = 0; i < lights(); ++i) sum += double(lighting().color(shot, i)[channel]) * share(p, i);
  return sum * double(m_fit.run().reflectance[channel][p]);
}

std::array<double, 3> DriftSample::hue(int p) const {
  std::array<double, 3> hue{};
  double mean = 0;
  for (size_t c = 0; c < 3; ++c) {
    hue[c] = std::log(std::max(double(m_fit.run().reflectance[c][p]), kLeastReflectance));
    mean += hue[c] / 3;
  }
  for (double& one : hue) one -= mean;
  return hue;
}

double DriftSample::hueVariance(int p) const {
  double mean = 0;
  for (int c = 0; c < 3; ++c) {
    double information = 0;
    for (int k = 0; k < lighting().shots; ++k) {
      const double y = predicted(k, c, p);
      information += y * y / double(m_context.estimator.noise.variance(float(y)));
    }
    mean += 1 / std::max(information, 1e-6) / 3;
  }
  return mean;
}

PixelMisfit DriftSample::misfit(int p) const {
  return misfitOf(m_context.estimator, m_run, m_fit.run(), p, m_tuning.modelError);
}

}  // namespace swaplight
