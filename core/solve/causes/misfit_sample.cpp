#include "core/solve/causes/misfit_sample.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/linear/decompositions.h"
#include "core/solve/estimators/matte_slopes.h"
#include "core/solve/estimators/run_scratch.h"
#include "core/solve/model/pixel_sample.h"

namespace swaplight {
namespace {

constexpr int kTogether = 64;  // pixels of a thread

float brightnessOf(const PixelRun& in, int shots, int p) {
  float sum = 0;
  for (int k = 0; k < shots; ++k)
    for (int c = 0; c < 3; ++c) sum += in.signal[k][c][p];
  return sum;
}

/// Every so manieth of the pixels that are bright enough.
std::vector<int> chosenPixels(const PixelRun& in, int shots, int count, double bright) {
  std::vector<float> brightness;
  for (int p = 0; p < in.count; ++p) brightness.push_back(brightnessOf(in, shots, p));
  std::vector<int> chosen;
  if (brightness.empty()) return chosen;
  std::vector<float> order = brightness;
  const double least = bright * double(quantile(std::span(order), .95));
  for (int p = 0; p < in.count; ++p)
    if (brightness[size_t(p)] > least) chosen.push_back(p);
  const size_t most = std::min(size_t(count), chosen.size());
  for (size_t j = 0; j < most; ++j) chosen[j] = chosen[j * chosen.size() / most];
  chosen.resize(most);
  return chosen;
}

}  // namespace

PixelMisfit misfitOf(const EstimatorContext& context, const PixelRun& in, const MatteRun& fit, int p,
                     double modelError) {
  const LightingMatrix& lighting = context.lighting;
  MatteSlopes slopes = matteSlopes(context, in, fit, p, modelError);
  PixelMisfit pixel;
  for (int i = 0; i < lighting.lights; ++i) pixel.share.push_back(fit.share[i][p]);
  for (int c = 0; c < 3; ++c) pixel.reflectance[c] = fit.reflectance[c][p];
  pixel.values.resize(3 * lighting.shots);
  for (int row = 0; row < 3 * lighting.shots; ++row)
    pixel.values[row] = double(in.signal[row / 3][row % 3][p]);
  pixel.directions = orthogonalComplement(slopes.own);
  pixel.residual = pixel.directions.transpose() * slopes.residual;
  pixel.predicted = std::move(slopes.predicted);
  pixel.weight = std::move(slopes.weight);
  return pixel;
}

PlacedPixels brightPixels(const ShotSignal& signal, int shots, int count, const CauseTuning& tuning) {
  std::vector<size_t> places;
  const PackedRun all = pixelSample(signal, shots, 6 * size_t(count), &places);
  const std::vector<int> chosen = chosenPixels(all.run(), shots, count, tuning.bright);
  PlacedPixels pixels{PackedRun(shots, std::max<size_t>(chosen.size(), 1)), {}};
  pixels.values.add(all.run(), chosen);
  for (const int p : chosen) pixels.places.push_back(places[size_t(p)]);
  return pixels;
}

std::vector<PixelMisfit> misfitSample(const EstimatorContext& context, const ShotSignal& signal,
                                      const PlacedPixels& pixels, const CauseTuning& tuning) {
  const PixelRun& in = pixels.values.run();
  if (in.count == 0) return {};
  MatteScratch fit(context.lighting.lights, in.count);
  MatteFit(context).fit(in, fit.run());
  const size_t width = size_t(signal.pixels().width());
  std::vector<PixelMisfit> sample(size_t(in.count));
  parallelRows(in.count, kTogether, [&](int begin, int end) {
    for (int p = begin; p < end; ++p) {
      PixelMisfit& pixel = sample[size_t(p)] = misfitOf(context, in, fit.run(), p, tuning.modelError);
      pixel.x = int(pixels.places[size_t(p)] % width);
      pixel.y = int(pixels.places[size_t(p)] / width);
    }
  });
  std::erase_if(sample, [](const PixelMisfit& pixel) {
    return !pixel.residual.allFinite() || pixel.residual.size() == 0;
  });
  return sample;
}

std::vector<PixelMisfit> misfitSample(const EstimatorContext& context, const ShotSignal& signal, int count,
                                      const CauseTuning& tuning) {
  return misfitSample(context, signal, brightPixels(signal, context.lighting.shots, count, tuning), tuning);
}

}  // namespace swaplight
