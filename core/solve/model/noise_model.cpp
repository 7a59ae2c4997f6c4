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

void addCodingError(const CapturePixels& pixels, NoiseModel& model) {
  if (pixels.codingError.empty()) return;
  std::vector<VariancePoint> points;
  for (const auto& [value, variance] : pixels.codingError)
    points.push_back({double(value), std::max(double(variance), 1e-12)});
  const std::array<double, 3> x = fitVariance(points);
  model.constant += float(x[0]);
  model.linear += float(x[1]);
  model.square += float(x[2]);
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
  // The step of an sRGB code is that of linear light at white over the curve's slope there.
  if (pixels.encoded) quantum *= 1.055F / 2.4F;
  const float quantisation = quantum * quantum / 12;
  NoiseModel model;
  model.constant = float(sensor.read * sensor.read);
  model.linear = float(1 / sensor.fullWell);
  model.square = colorUncertainty * colorUncertainty + kRelativeFloor * kRelativeFloor;
  if (pixels.encoded) {
    // A step of sRGB code is worth 1/12.92 of it in the blacks, and about 2.2 y^0.55 above.
    model.constant += quantisation / (12.92F * 12.92F);
    model.linear += 4.8F * quantisation;
  } else {
    model.constant += quantisation;
  }
  addCodingError(pixels, model);
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
