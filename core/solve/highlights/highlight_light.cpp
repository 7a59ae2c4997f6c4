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
constexpr double kApart = 1e-3;       // of the largest eigenvalue: lights that are told apart
constexpr float kDoubt = 1.5F;        // standard errors that may be noise
constexpr float kSurely = 3;          // standard errors above none
constexpr float kMatteError = 0.01F;  // of the matte light: what is known of the part that passes
constexpr int kMostSweeps = 60;       // of the fit
constexpr float kSettledFit = 1e-5F;  // of the highest
constexpr float kLeastGain = 1e-6F;   // of a light's own colours

using Lights = std::array<float, kMaxLights>;

/// Least squares of numbers >= 0, one a light: the equations' sums.
struct Equations {
  std::array<Lights, kMaxLights> products{};
  Lights right{};
};

/// By turns, each light given the others (coordinate descent: the problem is convex).
Lights nonNegative(const Equations& e, size_t lights) {
  Lights s{};
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    float change = 0, most = 0;
    for (size_t i = 0; i < lights; ++i) {
      if (e.products[i][i] <= kLeastGain) continue;
      float rest = e.right[i];
      for (size_t j = 0; j < lights; ++j)
        if (j != i) rest -= e.products[i][j] * s[j];
      const float next = std::max(0.0F, rest / e.products[i][i]);
      change = std::max(change, std::abs(next - s[i]));
      most = std::max(most, next);
      s[i] = next;
    }
    if (change <= kSettledFit * most) break;
  }
  return s;
}

class HighlightFit {
 public:
  HighlightFit(const Capture& capture, const CapturePixels& photographs, const SolvedSet& matte)
      : m_photographs(photographs),
        m_matte(matte),
        m_lighting(lightingFromCapture(capture)),
        m_noise(noiseModel(matte.report->noise, photographs, 0)),
        m_lights(static_cast<size_t>(capture.lightCount())) {
    for (const Shot& shot : capture.shots) m_exposure.push_back(std::exp2(shot.exposureStops));
    for (size_t k = 0; k < m_exposure.size(); ++k)
      for (int c = 0; c < 3; ++c) add(k, c, 0, m_all);
    Eigen::MatrixXd products(m_lights, m_lights);
    for (size_t i = 0; i < m_lights; ++i)
      for (size_t j = 0; j < m_lights; ++j)
        products(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = double(m_all.products[i][j]);
    const SymmetricEigen parts = symmetricEigen(products);
    if (!(parts.values(0) > kApart * parts.values(parts.values.size() - 1)))
      throw InputError(
          "{}: whose a highlight is cannot be told: the lights have too much the same colours in the "
          "photographs "
          "that are not crossed. Take one more of those, with other colours.",
          capture.file.empty() ? capture.name : capture.file.filename().string());
    const Eigen::MatrixXd inverse = inverseOf(products);
    for (size_t i = 0; i < m_lights; ++i)
      m_gain[i] =
          static_cast<float>(std::sqrt(inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i))));
  }

  /// Each light's highlight at a pixel, and the standard error of a photograph's value there.
  float at(size_t p, Lights& highlights) const {
    Equations equations;
    bool clipped = false;
    float brightest = 0, matte = 0;
    for (size_t k = 0; k < m_exposure.size(); ++k)
      for (int c = 0; c < 3; ++c) {
        const float value = m_photographs.shots[k].plane(c)[p];
        if (!std::isfinite(value)) return highlights = {}, 0.0F;
        const float left = matteLight(k, c, p);
        matte = std::max(matte, left);
        brightest = std::max(brightest, value);
        if (value < m_photographs.clipLevel[k])
          add(k, c, value - left, equations);
        else
          clipped = true;
      }
    if (clipped && !tellsApart(equations)) {
      equations = {};
      for (size_t k = 0; k < m_exposure.size(); ++k)
        for (int c = 0; c < 3; ++c)
          add(k, c, m_photographs.shots[k].plane(c)[p] - matteLight(k, c, p), equations);
    }
    highlights = nonNegative(equations, m_lights);
    const float own = std::hypot(m_matte.quality.plane(kSigma)[p], kMatteError) * matte;
    return std::sqrt(m_noise.variance(brightest) + own * own);
  }
  /// Of a light's highlight, over that of a photograph's value.
  [[nodiscard]] float gain(size_t light) const { return m_gain[light]; }
  [[nodiscard]] size_t lights() const { return m_lights; }

 private:
  void add(size_t shot, int channel, float beyond, Equations& equations) const {
    for (size_t i = 0; i < m_lights; ++i) {
      const float own = m_lighting.color(static_cast<int>(shot), static_cast<int>(i))[channel];
      equations.right[i] += own * beyond;
      for (size_t j = 0; j < m_lights; ++j)
        equations.products[i][j] +=
            own * m_lighting.color(static_cast<int>(shot), static_cast<int>(j))[channel];
    }
  }

  /// What a photograph would show of the matte set.
  [[nodiscard]] float matteLight(size_t shot, int channel, size_t p) const {
    float sum = m_photographs.ambient ? m_exposure[shot] * m_photographs.ambient->plane(channel)[p] : 0;
    for (size_t i = 0; i < m_lights; ++i)
      sum += m_lighting.color(static_cast<int>(shot), static_cast<int>(i))[channel] *
             m_matte.contributions[i].plane(channel)[p];
    return sum;
  }

  /// Whether what is not saturated says something of each light: near enough to how much all of it would.
  [[nodiscard]] bool tellsApart(const Equations& equations) const {
    Eigen::MatrixXd products(m_lights, m_lights);
    for (size_t i = 0; i < m_lights; ++i)
      for (size_t j = 0; j < m_lights; ++j)
        products(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
            double(equations.products[i][j]);
    const SymmetricEigen parts = symmetricEigen(products);
    return parts.values(0) > kApart * parts.values(parts.values.size() - 1);
  }

  const CapturePixels& m_photographs;
  const SolvedSet& m_matte;
  LightingMatrix m_lighting;
  NoiseModel m_noise;
  size_t m_lights;
  std::vector<float> m_exposure;
  Equations m_all;
  Lights m_gain{};
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
  std::atomic<int> done = 0;
  parallelRows(height, kBandRows, [&](int begin, int end) {
    Lights values;
    for (size_t p = size_t(begin) * size_t(width); p < size_t(end) * size_t(width); ++p) {
      error.plane(0)[p] = fit.at(p, values);
      for (size_t i = 0; i < raw.size(); ++i) raw[i].plane(0)[p] = values[i];
    }
    progress.update(float(done += end - begin) / float(height), "Finding highlights");
  });

  HighlightLight found;
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

void takeHighlights(const Capture& capture, const std::vector<Image>& highlights,
                    CapturePixels& photographs) {
  const LightingMatrix lighting = lightingFromCapture(capture);
  parallelRows(photographs.height(), kBandRows, [&](int begin, int end) {
    const size_t first = size_t(begin) * size_t(photographs.width());
    const size_t last = size_t(end) * size_t(photographs.width());
    for (size_t k = 0; k < photographs.shots.size(); ++k)
      for (int c = 0; c < 3; ++c) {
        float* values = photographs.shots[k].plane(c);
        for (size_t p = first; p < last; ++p) {
          if (!(values[p] < photographs.clipLevel[k])) continue;
          float rest = values[p];
          for (size_t i = 0; i < highlights.size(); ++i)
            rest -= lighting.color(static_cast<int>(k), static_cast<int>(i))[c] * highlights[i].plane(c)[p];
          values[p] = std::max(rest, std::min(values[p], 0.0F));  // no less than nothing of what it was
        }
      }
  });
}

}  // namespace swaplight
