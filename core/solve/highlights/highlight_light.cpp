#include "core/solve/highlights/highlight_light.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/linear/decompositions.h"
#include "core/solve/model/lighting_matrix.h"
#include "core/solve/model/noise_model.h"
#include "core/solve/model/pixel_run.h"

namespace swaplight {
namespace {

constexpr int kBandRows = 16;         // at once
constexpr double kApart = 0.01;       // of the largest eigenvalue: lights that are told apart
constexpr float kDoubt = 1.5F;        // standard errors that may be noise
constexpr float kSurely = 3;          // standard errors above none
constexpr float kMatteError = 0.01F;  // of the matte light: what is known of the part that passes
constexpr int kMostSweeps = 400;      // of the fit
constexpr float kSettledFit = 1e-5F;  // of the highest
constexpr float kLeastGain = 1e-6F;   // of a light's own colours, over the most of them
constexpr int kLost = kMoved | kNotFinite;

using Lights = std::array<float, kMaxLights>;

/// What photographs show of a set that is matte.
class MatteLight {
 public:
  MatteLight(const Capture& capture, const SolvedSet& set)
      : m_set(set), m_lighting(lightingFromCapture(capture)) {
    for (const Shot& shot : capture.shots) m_exposure.push_back(std::exp2(shot.exposureStops));
  }
  [[nodiscard]] float at(size_t shot, int channel, size_t p) const {
    float sum = m_set.ambient ? m_exposure[shot] * m_set.ambient->plane(channel)[p] : 0;
    for (size_t i = 0; i < m_set.contributions.size(); ++i)
      sum += color(shot, i, channel) * m_set.contributions[i].plane(channel)[p];
    return sum;
  }
  [[nodiscard]] float color(size_t shot, size_t light, int channel) const {
    return m_lighting.color(static_cast<int>(shot), static_cast<int>(light))[channel];
  }
  [[nodiscard]] size_t shots() const { return m_exposure.size(); }

 private:
  const SolvedSet& m_set;
  LightingMatrix m_lighting;
  std::vector<float> m_exposure;
};

/// Least squares of numbers >= 0, one a light: the equations' sums.
struct Equations {
  std::array<Lights, kMaxLights> products{};
  Lights right{};

  [[nodiscard]] Eigen::MatrixXd matrix(size_t lights) const {
    const auto size = static_cast<Eigen::Index>(lights);
    Eigen::MatrixXd result(size, size);
    for (size_t i = 0; i < lights; ++i)
      for (size_t j = 0; j < lights; ++j)
        result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = double(products[i][j]);
    return result;
  }
};

bool tellApart(const Eigen::MatrixXd& products) {
  const SymmetricEigen parts = symmetricEigen(products);
  return parts.values(0) > kApart * parts.values(parts.values.size() - 1);
}

/// By turns, each light given the others, from `start` (coordinate descent: the problem is convex).
Lights nonNegative(const Equations& e, size_t lights, Lights start) {
  float brightest = 0;
  for (size_t i = 0; i < lights; ++i) brightest = std::max(brightest, e.products[i][i]);
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    float change = 0, most = 0;
    for (size_t i = 0; i < lights; ++i) {
      float rest = e.right[i];
      for (size_t j = 0; j < lights; ++j)
        if (j != i) rest -= e.products[i][j] * start[j];
      const bool seen = e.products[i][i] > kLeastGain * brightest;
      const float next = seen ? std::max(0.0F, rest / e.products[i][i]) : 0.0F;
      change = std::max(change, std::abs(next - start[i]));
      most = std::max(most, next);
      start[i] = next;
    }
    if (change <= kSettledFit * most) break;
  }
  return start;
}

class HighlightFit {
 public:
  HighlightFit(const Capture& capture, const CapturePixels& photographs, const SolvedSet& matte)
      : m_photographs(photographs),
        m_matte(matte),
        m_light(capture, matte),
        m_noise(noiseModel(matte.report->noise, photographs, 0)),
        m_lights(static_cast<size_t>(capture.lightCount())) {
    Equations all;
    for (size_t k = 0; k < m_light.shots(); ++k)
      for (int c = 0; c < 3; ++c) add(k, c, 0, all);
    const Eigen::MatrixXd products = all.matrix(m_lights);
    if (!tellApart(products))
      throw InputError(
          "{}: whose a highlight is cannot be told: in the photographs that are not crossed the lights are "
          "off, or have too much the same colours. Take one more of those, with other colours.",
          capture.calledName());
    const Eigen::MatrixXd inverse = inverseOf(products);
    for (size_t i = 0; i < m_lights; ++i)
      for (size_t j = 0; j < m_lights; ++j)
        m_inverse[i][j] =
            static_cast<float>(inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  }

  struct Found {
    Lights highlights{};
    float error = 0;  ///< standard, of a photograph's value
    bool clipped = false;
  };
  [[nodiscard]] Found at(size_t p) const {
    Found found;
    if (static_cast<int>(m_matte.quality.plane(kFlags)[p]) & kLost) return found;
    Equations equations, all;
    float brightest = 0, matte = 0;
    for (size_t k = 0; k < m_light.shots(); ++k)
      for (int c = 0; c < 3; ++c) {
        const float value = m_photographs.shots[k].plane(c)[p];
        if (!std::isfinite(value)) return {};
        const float without = m_light.at(k, c, p);
        matte = std::max(matte, without);
        brightest = std::max(brightest, value);
        const bool clipped = !(value < m_photographs.clipLevel[k]);
        add(k, c, m_photographs.shown(k, value) - without, all);
        if (!clipped) add(k, c, value - without, equations);
        found.clipped |= clipped;
      }
    if (found.clipped && tellApart(equations.matrix(m_lights)))
      found.highlights = nonNegative(equations, m_lights, {});
    else
      found.highlights = solved(all);
    const float own = std::hypot(m_matte.quality.plane(kSigma)[p], kMatteError) * matte;
    found.error = std::sqrt(m_noise.variance(brightest) + own * own);
    return found;
  }
  /// The standard error of a light's highlight, over that of a photograph's value.
  [[nodiscard]] float gain(size_t light) const { return std::sqrt(m_inverse[light][light]); }
  [[nodiscard]] size_t lights() const { return m_lights; }

 private:
  void add(size_t shot, int channel, float beyond, Equations& equations) const {
    for (size_t i = 0; i < m_lights; ++i) {
      const float own = m_light.color(shot, i, channel);
      equations.right[i] += own * beyond;
      for (size_t j = 0; j < m_lights; ++j) equations.products[i][j] += own * m_light.color(shot, j, channel);
    }
  }

  /// Of all values: exact where no light's is negative.
  [[nodiscard]] Lights solved(const Equations& all) const {
    Lights free{};
    bool negative = false;
    for (size_t i = 0; i < m_lights; ++i) {
      for (size_t j = 0; j < m_lights; ++j) free[i] += m_inverse[i][j] * all.right[j];
      negative |= free[i] < 0;
      free[i] = std::max(free[i], 0.0F);
    }
    return negative ? nonNegative(all, m_lights, free) : free;
  }

  const CapturePixels& m_photographs;
  const SolvedSet& m_matte;
  MatteLight m_light;
  NoiseModel m_noise;
  size_t m_lights;
  std::array<Lights, kMaxLights> m_inverse{};
};

/// The mean of the squares of 3 x 3 pixels.
float energyAround(const Image& image, int x, int y) {
  float sum = 0;
  int count = 0;
  for (int v = std::max(0, y - 1); v <= std::min(image.height() - 1, y + 1); ++v)
    for (int u = std::max(0, x - 1); u <= std::min(image.width() - 1, x + 1); ++u) {
      const float value = image.view().at(0, u, v);
      sum += value * value;
      ++count;
    }
  return sum / static_cast<float>(count);
}

}  // namespace

HighlightLight highlightLight(const Capture& capture, const CapturePixels& photographs,
                              const SolvedSet& matte, const Progress& progress) {
  const HighlightFit fit(capture, photographs, matte);
  const int width = photographs.width(), height = photographs.height();
  ImageSpec single = photographs.shots.front().spec();
  single.channels = {"Y"};
  std::vector<Image> raw;
  for (size_t i = 0; i < fit.lights(); ++i) raw.emplace_back(single);
  Image error(single);
  HighlightLight found;
  found.clipped.resize(error.pixelCount(), 0);
  std::atomic<int> done = 0;
  parallelRows(height, kBandRows, [&](int begin, int end) {
    for (size_t p = size_t(begin) * size_t(width); p < size_t(end) * size_t(width); ++p) {
      const HighlightFit::Found here = fit.at(p);
      error.plane(0)[p] = here.error;
      found.clipped[p] = here.clipped;
      for (size_t i = 0; i < raw.size(); ++i) raw[i].plane(0)[p] = here.highlights[i];
    }
    progress.update(float(done += end - begin) / float(height), "Finding highlights");
  });

  for (size_t i = 0; i < raw.size(); ++i)
    found.lights.emplace_back(ImageSpec{width, height, {"R", "G", "B"}, matte.colorSpace()});
  std::atomic<size_t> sure = 0;
  parallelRows(height, kBandRows, [&](int begin, int end) {
    size_t some = 0;
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < width; ++x) {
        const size_t p = size_t(y) * size_t(width) + size_t(x);
        bool here = false;
        for (size_t i = 0; i < raw.size(); ++i) {
          const float sigma = fit.gain(i) * error.plane(0)[p];
          const float energy = energyAround(raw[i], x, y), doubt = kDoubt * sigma;
          const float kept = energy > doubt * doubt ? 1 - doubt * doubt / energy : 0.0F;
          const float rest = kept * raw[i].plane(0)[p];
          here |= rest > kSurely * sigma;
          for (int c = 0; c < 3; ++c) found.lights[i].plane(c)[p] = rest;
        }
        some += here;
      }
    sure += some;
  });
  found.part = static_cast<double>(sure) / static_cast<double>(error.pixelCount());
  return found;
}

void takeHighlights(const Capture& capture, const std::vector<Image>& highlights, const SolvedSet& matte,
                    CapturePixels& photographs) {
  const MatteLight light(capture, matte);
  parallelRows(photographs.height(), kBandRows, [&](int begin, int end) {
    const size_t first = size_t(begin) * size_t(photographs.width());
    const size_t last = size_t(end) * size_t(photographs.width());
    for (size_t k = 0; k < photographs.shots.size(); ++k) {
      const float clip = photographs.clipLevel[k];
      for (int c = 0; c < 3; ++c) {
        float* values = photographs.shots[k].plane(c);
        for (size_t p = first; p < last; ++p) {
          if (!std::isfinite(values[p])) continue;
          if (!(values[p] < clip)) {  // how much of it is highlight is not known; what the rest is, is
            values[p] = std::min(light.at(k, c, p), std::nextafter(clip, 0.0F));
            continue;
          }
          float rest = values[p];
          for (size_t i = 0; i < highlights.size(); ++i)
            rest -= light.color(k, i, c) * highlights[i].plane(c)[p];
          values[p] = std::max(rest, std::min(values[p], 0.0F));  // no less than nothing of what it was
        }
      }
    }
  });
}

}  // namespace swaplight
