#include "core/solve/model/noise_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/quantile.h"
#include "core/solve/model/variance_fit.h"

namespace swaplight {
namespace {

constexpr int kBlock = 8;
constexpr int kBins = 24;
constexpr double kQuietFraction = 0.2;
constexpr double kQuietBias = 0.697;  // the 20 % quantile of chi-square with 16 degrees of freedom, over 16
constexpr float kRelativeFloor = 1.5e-4F;  // no file holds a value better than half float rounds it

struct Bin {
  std::vector<float> variances;
  double signal = 0;
};

int binOf(double signal) {
  // Six bins a decade, from 1e-4 of full scale up.
  return std::clamp(static_cast<int>(6 * (std::log10(std::max(signal, 1e-6)) + 4)), 0, kBins - 1);
}

void addBlocks(const Image& shot, int channel, float clip, std::array<Bin, kBins>& bins) {
  const ImageView view = shot.view();
  const int step = std::max(kBlock, int(std::sqrt(double(shot.pixelCount()) / 40000.0)));
  for (int by = 0; by + kBlock <= view.height; by += step) {
    for (int bx = 0; bx + kBlock <= view.width; bx += step) {
      double sum = 0;
      double squares = 0;
      bool usable = true;
      for (int y = by; y < by + kBlock && usable; y += 2) {
        const float* a = view.row(channel, y);
        const float* b = view.row(channel, y + 1);
        for (int x = bx; x < bx + kBlock; x += 2) {
          const float total = a[x] + a[x + 1] + b[x] + b[x + 1];
          const float largest = std::max(std::max(a[x], a[x + 1]), std::max(b[x], b[x + 1]));
          if (!std::isfinite(total) || largest >= clip) {
            usable = false;
            break;
          }
          const float d = 0.5F * (a[x] - a[x + 1] - b[x] + b[x + 1]);
          sum += total;
          squares += double(d) * d;
        }
      }
      if (!usable) continue;
      const double mean = sum / (kBlock * kBlock);
      Bin& bin = bins[size_t(binOf(mean))];
      bin.variances.push_back(float(4 * squares / (kBlock * kBlock)));
      bin.signal += std::max(mean, 0.0);
    }
  }
}

/// The mean of an image's positive values.
float meanOf(const Image& image) {
  double sum = 0;
  size_t count = 0;
  for (int c = 0; c < image.channelCount(); ++c)
    for (size_t p = 0; p < image.pixelCount(); ++p)
      if (const float value = image.plane(c)[p]; value > 0 && std::isfinite(value)) sum += value, ++count;
  return count ? float(sum / double(count)) : 0;
}

std::array<double, 3> fitted(const std::vector<ValueVariance>& error) {
  std::vector<VariancePoint> points;
  for (const auto& [value, variance] : error)
    points.push_back({double(value), std::max(double(variance), 1e-12)});
  return fitVariance(points);
}

void add(const std::array<double, 3>& variance, double times, NoiseModel& model) {
  model.constant += float(times * variance[0]);
  model.linear += float(times * variance[1]);
  model.square += float(times * variance[2]);
}

/// No such polynomial follows a coding's curve: what this one is to be multiplied by to be nowhere below it,
/// black aside.
double timesBelow(const std::vector<ValueVariance>& error, const std::array<double, 3>& fit) {
  double times = 1;
  for (const auto& [value, variance] : error)
    if (value > error.front().value)
      times = std::max(times, double(variance) / std::max(fit[0] + value * (fit[1] + value * fit[2]), 1e-12));
  return times;
}

void addRounding(const CapturePixels& pixels, double quantisation, NoiseModel& model) {
  if (pixels.rounding.empty()) {
    model.constant += float(quantisation);
    return;
  }
  const std::array<double, 3> fit = fitted(pixels.rounding);
  add(fit, quantisation * timesBelow(pixels.rounding, fit), model);
}

}  // namespace

SensorNoise estimateSensorNoise(const CapturePixels& pixels) {
  std::array<Bin, kBins> bins;
  for (size_t k = 0; k < pixels.shots.size(); ++k)
    for (int c = 0; c < 3; ++c) addBlocks(pixels.shots[k], c, pixels.clipLevel[k], bins);

  // Fit variance = a + b signal, relative errors equal in every bin; two unknowns, both >= 0.
  double ss = 0, sx = 0, sxx = 0, sy = 0, sxy = 0;
  for (int round = 0; round < 4; ++round) {
    const double a0 = round ? std::max(0.0, (sy * sxx - sx * sxy) / std::max(ss * sxx - sx * sx, 1e-300)) : 0;
    const double b0 = round ? std::max(0.0, (ss * sxy - sx * sy) / std::max(ss * sxx - sx * sx, 1e-300)) : 0;
    ss = sx = sxx = sy = sxy = 0;
    for (Bin& bin : bins) {
      if (bin.variances.size() < 20) continue;
      const double variance = quantile(std::span(bin.variances), kQuietFraction) / kQuietBias;
      const double signal = bin.signal / double(bin.variances.size());
      const double expected = std::max(round ? a0 + b0 * signal : variance, 1e-14);
      const double w = std::sqrt(double(bin.variances.size())) / (expected * expected);
      ss += w, sx += w * signal, sxx += w * signal * signal, sy += w * variance, sxy += w * signal * variance;
    }
  }
  SensorNoise noise;
  if (ss <= 0) return {1e-3, 1e5};  // hardly any pixels: a good camera
  const double det = ss * sxx - sx * sx;
  double a = det > 1e-12 * ss * sxx ? (sy * sxx - sx * sxy) / det : sy / ss;
  double b = det > 1e-12 * ss * sxx ? (ss * sxy - sx * sy) / det : 0;
  if (a < 0) a = 0, b = sxy / std::max(sxx, 1e-300);
  if (b < 0) b = 0, a = sy / ss;
  noise.read = std::sqrt(std::max(a, 1e-12));
  noise.fullWell = 1 / std::max(b, 1e-9);
  return noise;
}

NoiseModel noiseModel(const SensorNoise& sensor, const CapturePixels& pixels, float colorUncertainty) {
  float quantum = 0;
  for (float q : pixels.quantum) quantum = std::max(quantum, q);
  NoiseModel model;
  model.constant = float(sensor.read * sensor.read);
  model.linear = float(1 / sensor.fullWell);
  model.square = colorUncertainty * colorUncertainty + kRelativeFloor * kRelativeFloor;
  addRounding(pixels, double(quantum) * quantum / 12, model);
  if (!pixels.codingError.empty()) add(fitted(pixels.codingError), 1, model);
  if (pixels.ambient) {
    // It is subtracted: its photons are noise of every shot, and its picture has noise of its own.
    const float photons = model.linear * meanOf(*pixels.ambient);
    model.constant = 2 * (model.constant + photons);
  }
  // A perfect sensor would make weights infinite.
  model.constant = std::max(model.constant, 1e-12F);
  return model;
}

}  // namespace swaplight
