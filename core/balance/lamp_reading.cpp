#include "core/balance/lamp_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numbers>

#include "core/balance/lamp_fit.h"
#include "core/ocio/luminance.h"
#include "core/relight/relight.h"
#include "core/set/measured_pixels.h"
#include "core/solve/registration/align_shots.h"
#include "core/solve/registration/moved_shots.h"

namespace swaplight {
namespace {

constexpr size_t kMostBlocks = size_t{1} << 18;
constexpr double kLit = 3;              // standard errors that a lamp which is on is above none
constexpr float kFaintestLamp = 1e-3F;  // of the brightest lamp: less is its spill, not the lamp
constexpr double kWorseThanAny = 0.2;   // real gels and gloss leave a few per cent
constexpr double kMostLeftOut = 0.3;
constexpr double kPoorlyKnown = 0.05;  // relative standard error of a lamp's level worth a word
constexpr double kAlike = 1e-3;        // of fitLamps' separation: two lights with one pattern to 3 %

/// Blocks of 2 x 2 pixels that the photograph and the set both know.
class BlockReader {
 public:
  BlockReader(const SolvedSet& set, const Image& photograph, float clip)
      : m_set(set), m_photograph(photograph), m_clip(clip) {
    for (const Image& contribution : set.contributions) m_columns.push_back(&contribution);
  }

  /// `fixedAmbient`: its level, taken off the photograph; nothing: one more column.
  LampBlocks read(std::optional<float> fixedAmbient, size_t& tried) {
    LampBlocks blocks;
    blocks.lights = m_set.lightCount();
    blocks.ambient = m_set.ambient && !fixedAmbient;
    if (blocks.ambient) m_columns.push_back(&*m_set.ambient);
    const int across = m_photograph.width() / 2, down = m_photograph.height() / 2;
    const double all = double(across) * double(down);
    const int step = std::max(1, int(std::ceil(std::sqrt(all / double(kMostBlocks)))));
    tried = 0;
    for (int y = 0; y < down; y += step)
      for (int x = 0; x < across; x += step) {
        ++tried;
        if (!usable(2 * x, 2 * y)) continue;
        add(2 * x, 2 * y, m_set.ambient ? fixedAmbient.value_or(0) : 0, blocks);
        blocks.tile.push_back(y * kLampTilesDown / down * kLampTilesAcross + x * kLampTilesAcross / across);
      }
    blocks.count = blocks.tile.size();
    return blocks;
  }

 private:
  [[nodiscard]] bool usable(int x, int y) const {
    for (int dy = 0; dy < 2; ++dy)
      for (int dx = 0; dx < 2; ++dx) {
        if (!isMeasured(m_set, x + dx, y + dy)) return false;
        for (int c = 0; c < 3; ++c) {
          const float value = m_photograph.view().at(c, x + dx, y + dy);
          if (!std::isfinite(value) || value >= m_clip) return false;
        }
      }
    return true;
  }

  static float mean(const Image& image, int channel, int x, int y) {
    const ImageView view = image.view();
    const float* a = view.row(channel, y) + x;
    const float* b = view.row(channel, y + 1) + x;
    return 0.25F * (a[0] + a[1] + b[0] + b[1]);
  }

  void add(int x, int y, float ambient, LampBlocks& blocks) const {
    for (int c = 0; c < 3; ++c) {
      float value = mean(m_photograph, c, x, y);
      if (ambient != 0) value -= ambient * mean(*m_set.ambient, c, x, y);
      blocks.value[size_t(c)].push_back(value);
      for (const Image* column : m_columns) blocks.columns[size_t(c)].push_back(mean(*column, c, x, y));
    }
    blocks.sigma.push_back(m_set.quality.empty() ? 0 : mean(m_set.quality, kSigma, x, y));
  }

  const SolvedSet& m_set;
  const Image& m_photograph;
  float m_clip;
  std::vector<const Image*> m_columns;
};

NoiseModel noiseOf(const CapturePixels& photograph, const SensorNoise& sensor) {
  return noiseModel(sensor, photograph, 0);
}

SensorNoise sensorOf(const SolvedSet& set, const CapturePixels& photograph,
                     const LampReadingOptions& options) {
  if (options.noise) return *options.noise;
  if (const auto given = noiseInFrame(set.capture)) return *given;
  return estimateSensorNoise(photograph);
}

ReadLamp readLamp(const SolvedSet& set, const LampFit& fit, int light, float exposure, const Rgb& weights) {
  const int lights = set.lightCount();
  ReadLamp lamp;
  lamp.light = set.capture.lights[size_t(light)].name;
  double variance = 0;
  for (int c = 0; c < 3; ++c) {
    const int u = c * lights + light;
    lamp.color[c] = float(fit.level[u]) / exposure;
    lamp.error[c] = float(std::sqrt(fit.covariance(u, u))) / exposure;
    lamp.luminance += weights[c] * lamp.color[c];
    for (int d = 0; d < 3; ++d)
      variance += double(weights[c]) * double(weights[d]) * fit.covariance(u, d * lights + light);
  }
  lamp.luminanceError = float(std::sqrt(std::max(variance, 0.0))) / exposure;
  return lamp;
}

std::vector<ReadLamp> lampsOf(const SolvedSet& set, const LampFit& fit, float exposure) {
  const Rgb weights = luminanceWeights(set.colorSpace());
  std::vector<ReadLamp> lamps;
  for (int i = 0; i < set.lightCount(); ++i) lamps.push_back(readLamp(set, fit, i, exposure, weights));
  float brightest = 0;
  for (const ReadLamp& lamp : lamps) brightest = std::max(brightest, lamp.luminance);
  for (ReadLamp& lamp : lamps)
    lamp.on = lamp.luminance > kLit * lamp.luminanceError && lamp.luminance > kFaintestLamp * brightest;
  return lamps;
}

/// Two lights that light the same things in the same way: their sum is known, each alone is not.
void warnOfLikeLights(const SolvedSet& set, const LampFit& fit, std::vector<std::string>& warnings) {
  const auto worst = std::min_element(fit.separation.begin(), fit.separation.end()) - fit.separation.begin();
  if (set.lightCount() < 2 || fit.separation[size_t(worst)] > kAlike) return;
  const Eigen::VectorXd mixture = fit.weakest[size_t(worst)].cwiseAbs();
  Eigen::Index first = 0, second = 0;
  mixture.maxCoeff(&first);
  Eigen::VectorXd others = mixture;
  others[first] = -1;
  others.maxCoeff(&second);
  if (mixture[second] < 0.1) return;  // one light alone, that is nearly nowhere: its own errors say it
  const auto name = [&](Eigen::Index i) { return set.capture.lights[size_t(i)].name; };
  warnings.push_back(fmt::format(
      "{} and {} light the same parts of the set in the same way: only what they give together is known",
      name(std::min(first, second)), name(std::max(first, second))));
}

void warnOfLamps(const LampReading& reading, std::vector<std::string>& warnings) {
  for (const ReadLamp& lamp : reading.lamps) {
    if (!std::isfinite(lamp.error.r + lamp.error.g + lamp.error.b))
      warnings.push_back(
          fmt::format("{} lights nothing of what can be used: its colour is not known", lamp.light));
    else if (lamp.on && lamp.luminanceError > kPoorlyKnown * lamp.luminance)
      warnings.push_back(fmt::format("the level of {} is known to {:.0f} % only", lamp.light,
                                     100 * lamp.luminanceError / lamp.luminance));
  }
}

void warnOfMisfit(const LampReading& reading, std::vector<std::string>& warnings) {
  const bool shifted = reading.shift && worthMoving(*reading.shift);
  if (reading.misfit > kWorseThanAny && reading.misfit > 2 * reading.expectedMisfit)
    warnings.push_back(
        fmt::format("the photograph does not look like this set (it differs by {:.0f} %): is it the same "
                    "camera position, and the right colour space (--color-space)?",
                    100 * reading.misfit));
  else if (reading.leftOut > kMostLeftOut)
    warnings.push_back(fmt::format(
        "{:.0f} % of the picture is not explained by these lamps and was left out: something moved, or other "
        "light was on",
        100 * reading.leftOut));
  if (shifted)
    warnings.push_back(
        reading.shift->isTurned()
            ? fmt::format("the photograph is turned by {:+.2f} degrees against the set, or zoomed: "
                          "aligning moves it (--align)",
                          double(reading.shift->turn) * 180 / std::numbers::pi)
            : fmt::format(
                  "the photograph lies {:+.1f}, {:+.1f} pixels beside the set: aligning moves it (--align)",
                  reading.shift->x, reading.shift->y));
}

/// The part of the blocks that weighs less than half of what it would.
double leftOutOf(const LampFit& fit) {
  const auto out = std::count_if(fit.weight.begin(), fit.weight.end(), [](float w) { return w < 0.25F; });
  return double(out) / double(std::max<size_t>(1, fit.weight.size()));
}

LampReading readFrom(const SolvedSet& set, const CapturePixels& photograph,
                     const LampReadingOptions& options) {
  LampReading reading;
  reading.noise = sensorOf(set, photograph, options);
  const float exposure = std::exp2(options.exposureStops);
  size_t tried = 0;
  std::optional<float> ambient;
  if (set.ambient && options.ambient) ambient = *options.ambient * exposure;
  const LampBlocks blocks =
      BlockReader(set, photograph.shots.front(), photograph.clipLevel.front()).read(ambient, tried);
  if (blocks.count < size_t(4 * blocks.columnCount()))
    throw InputError(
        "the photograph has no usable pixels where the set is known: it is clipped, or nothing but what "
        "moved");
  const LampFit fit = fitLamps(blocks, noiseOf(photograph, reading.noise));
  reading.lamps = lampsOf(set, fit, exposure);
  if (set.ambient) reading.ambient = options.ambient;
  if (blocks.ambient) {
    const Eigen::Index last = fit.level.size() - 1;
    reading.ambient = float(fit.level[last]) / exposure;
    reading.ambientError = float(std::sqrt(fit.covariance(last, last))) / exposure;
  }
  reading.misfit = fit.misfit;
  reading.expectedMisfit = fit.noise;
  reading.used = double(blocks.count) / double(std::max<size_t>(1, tried));
  reading.leftOut = leftOutOf(fit);
  warnOfLikeLights(set, fit, reading.warnings);
  return reading;
}

/// The set under the lamps that were read, and the photograph beside it.
CapturePixels besidePrediction(const SolvedSet& set, const CapturePixels& photograph,
                               const LampReading& reading, float exposure) {
  std::vector<Rgb> factors;
  for (const ReadLamp& lamp : reading.lamps) factors.push_back(exposure * lamp.color);
  CapturePixels both;
  both.shots.push_back(relight(set, factors, exposure * reading.ambient.value_or(1)));
  both.shots.push_back(photograph.shots.front().clone());
  both.clipLevel = {std::numeric_limits<float>::infinity(), photograph.clipLevel.front()};
  both.quantum = {0, photograph.quantum.front()};
  both.rounding = photograph.rounding;
  return both;
}

}  // namespace

LampReading readLamps(const SolvedSet& set, const CapturePixels& photograph,
                      const LampReadingOptions& options, const Progress& progress) {
  progress.update(0.1F, "reading the lamps");
  LampReading reading = readFrom(set, photograph, options);
  progress.update(0.5F, "comparing with the set");
  CapturePixels both = besidePrediction(set, photograph, reading, std::exp2(options.exposureStops));
  reading.shift = measureShifts(both).back();
  if (options.align && worthMoving(*reading.shift)) {
    progress.update(0.7F, "aligning");
    CapturePixels moved = movedShots(both, {ShotShift{}, *reading.shift});
    moved.shots.erase(moved.shots.begin());
    moved.clipLevel.erase(moved.clipLevel.begin());
    moved.quantum.erase(moved.quantum.begin());
    const ShotShift shift = *reading.shift;
    reading = readFrom(set, moved, options);
    warnOfMisfit(reading, reading.warnings);
    reading.shift = shift;
  } else {
    warnOfMisfit(reading, reading.warnings);
  }
  warnOfLamps(reading, reading.warnings);
  return reading;
}

}  // namespace swaplight
