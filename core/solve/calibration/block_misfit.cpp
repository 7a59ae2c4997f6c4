#include "core/solve/calibration/block_misfit.h"

#include <algorithm>
#include <cmath>

#include "core/solve/estimators/run_scratch.h"
#include "core/solve/model/packed_run.h"

namespace swaplight {
namespace {

constexpr int kSide = 8;
constexpr int kPixels = BlockMisfit::kPixels;
static_assert(kPixels == kSide * kSide);

/// Blocks of usable pixels, one after the other, their rows one after the other.
PackedRun gatherBlocks(const ShotSignal& signal, int shots, int count,
                       std::vector<size_t>* places = nullptr) {
  const int width = signal.pixels().width();
  const int height = signal.pixels().height();
  const double across = std::sqrt(double(count) * width / std::max(height, 1));
  const int columns = std::clamp(int(across), 1, std::max(width / kSide, 1));
  const int rows = std::clamp(int(double(count) / across), 1, std::max(height / kSide, 1));
  PackedRun blocks(shots, width < kSide || height < kSide ? 0 : size_t(columns) * size_t(rows) * kPixels);
  if (width < kSide || height < kSide) return blocks;
  std::vector<float> scratch;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int x = (width - kSide) * (2 * column + 1) / (2 * columns);
      const int y = (height - kSide) * (2 * row + 1) / (2 * rows);
      const auto first = [&](int line) { return size_t(y + line) * size_t(width) + size_t(x); };
      bool usable = true;
      for (int line = 0; line < kSide; ++line) usable = usable && !signal.flagged(first(line), kSide);
      if (!usable) continue;
      if (places) places->push_back(first(0));
      for (int line = 0; line < kSide; ++line) {
        PixelRun in;
        signal.run(first(line), kSide, true, scratch, in);
        for (int p = 0; p < kSide; ++p) blocks.add(in, p);
      }
    }
  return blocks;
}

/// Sum of squared second differences of a square of `side` values.
float squaredDifferences(const float* values, int side) {
  float sum = 0;
  for (int y = 0; y < side; y += 2)
    for (int x = 0; x < side; x += 2) {
      const float* a = values + y * side + x;
      const float d = .5F * (a[0] - a[1] - a[side] + a[side + 1]);
      sum += d * d;
    }
  return sum;
}

/// The means of 2 x 2 values, times 2: noise of unit variance keeps it.
void halve(const float* values, float* half) {
  for (int y = 0; y < kSide; y += 2)
    for (int x = 0; x < kSide; x += 2) {
      const float* a = values + y * kSide + x;
      *half++ = .5F * (a[0] + a[1] + a[kSide] + a[kSide + 1]);
    }
}

/// What one shot and channel of a block adds.
struct Layer {
  float fine = 0, coarse = 0;
  double residual = 0, signal = 0, variance = 0;  ///< sums over the block
};

Layer layerOf(const NoiseModel& noise, const float* color, const float* y, const MatteRun& fit, int lights,
              int channel, int first) {
  float weighted[kPixels];
  float half[kPixels / 4];
  Layer layer;
  for (int p = 0; p < kPixels; ++p) {
    float g = 0;
    for (int i = 0; i < lights; ++i) g += color[i] * fit.share[i][first + p];
    const float predicted = g * fit.reflectance[channel][first + p];
    const float variance = noise.variance(predicted);
    const float residual = y[first + p] - predicted;
    weighted[p] = residual / std::sqrt(variance);
    layer.residual += residual;
    layer.signal += y[first + p];
    layer.variance += variance;
  }
  halve(weighted, half);
  layer.fine = squaredDifferences(weighted, kSide);
  layer.coarse = squaredDifferences(half, kSide / 2);
  return layer;
}

}  // namespace

std::vector<BlockMisfit> blockMisfits(const MatteFit& matte, const LightingMatrix& lighting,
                                      const NoiseModel& noise, const ShotSignal& signal, int count) {
  const PackedRun gathered = gatherBlocks(signal, lighting.shots, count);
  const PixelRun& in = gathered.run();
  MatteScratch scratch(lighting.lights, in.count);
  const MatteRun& fit = scratch.run();
  if (in.count > 0) matte.fit(in, fit);
  std::vector<BlockMisfit> blocks;
  std::vector<float> color(static_cast<size_t>(lighting.lights));
  for (int first = 0; first < in.count; first += kPixels) {
    BlockMisfit block;
    int held = 0;
    for (int i = 0; i < lighting.lights; ++i)
      held += int(std::count_if(fit.share[i] + first, fit.share[i] + first + kPixels,
                                [](float share) { return share <= 0; }));
    block.freedom = float(matte.freedom()) + float(held) / kPixels;
    double squared = 0, power = 0, variance = 0;
    for (int k = 0; k < lighting.shots; ++k)
      for (int c = 0; c < 3; ++c) {
        for (int i = 0; i < lighting.lights; ++i) color[size_t(i)] = lighting.color(k, i)[c];
        const Layer layer = layerOf(noise, color.data(), in.signal[k][c], fit, lighting.lights, c, first);
        block.fine += layer.fine;
        block.coarse += layer.coarse;
        squared += layer.residual * layer.residual / kPixels / kPixels;
        power += layer.signal * layer.signal / kPixels / kPixels;
        variance += layer.variance / kPixels;
        block.brightness += float(layer.signal / kPixels / (3 * lighting.shots));
      }
    block.fine /= BlockMisfit::kFineDegrees * block.freedom;
    block.coarse /= BlockMisfit::kCoarseDegrees * block.freedom;
    const double values = 3.0 * lighting.shots;
    const double noiseLeft = block.fine * variance / values / kPixels;
    block.smooth = float((squared / block.freedom - noiseLeft) / std::max(power / values, 1e-30));
    blocks.push_back(block);
  }
  return blocks;
}

std::vector<BlockMean> blockMeans(const ShotSignal& signal, int shots, int count) {
  std::vector<size_t> places;
  const PackedRun gathered = gatherBlocks(signal, shots, count, &places);
  const PixelRun& in = gathered.run();
  std::vector<BlockMean> means;
  for (int first = 0; first < in.count; first += kPixels) {
    BlockMean& mean = means.emplace_back(BlockMean{places[size_t(first / kPixels)], {}});
    for (int k = 0; k < shots; ++k)
      for (int c = 0; c < 3; ++c) {
        float sum = 0;
        for (int p = 0; p < kPixels; ++p) sum += in.signal[k][c][first + p];
        mean.values.push_back(sum / kPixels);
      }
  }
  return means;
}

}  // namespace swaplight
