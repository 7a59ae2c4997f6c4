#include "core/solve/causes/additivity_sample.h"

#include <algorithm>
#include <cmath>

#include "core/linear/decompositions.h"

namespace swaplight {
namespace {

constexpr float kSameColor = 1e-4F;  // relative: files round

bool isSame(const Rgb& a, const Rgb& b) {
  for (int c = 0; c < 3; ++c)
    if (std::abs(a[c] - b[c]) > kSameColor * std::max(a[c], b[c])) return false;
  return true;
}

/// A light under one of its gels.
struct Lamp {
  int light;
  Rgb color;
};

/// Which lamps are on in which shot, times its exposure: a column each. What colours gels really have does
/// not matter, as long as the same gel has the same. `ambient`: light that was the same in all shots is one
/// more.
Eigen::MatrixXd lampsOf(const LightingMatrix& lighting, const std::vector<double>& exposure, bool ambient) {
  std::vector<Lamp> lamps;
  Eigen::MatrixXd on = Eigen::MatrixXd::Zero(lighting.shots, lighting.shots * lighting.lights + 1);
  for (int k = 0; k < lighting.shots; ++k)
    for (int i = 0; i < lighting.lights; ++i) {
      const Rgb color = lighting.color(k, i) / float(exposure[size_t(k)]);
      if (isSame(color, Rgb(0))) continue;
      auto found = std::find_if(lamps.begin(), lamps.end(), [&](const Lamp& lamp) {
        return lamp.light == i && isSame(lamp.color, color);
      });
      if (found == lamps.end()) found = lamps.insert(lamps.end(), {i, color});
      on(k, found - lamps.begin()) = exposure[size_t(k)];
    }
  auto count = Eigen::Index(lamps.size());
  for (int k = 0; ambient && k < lighting.shots; ++k) on(k, count) = exposure[size_t(k)];
  return on.leftCols(count + (ambient ? 1 : 0));
}

/// What the lamps do to all values: channels do not mix.
Eigen::MatrixXd ownOf(const Eigen::MatrixXd& lamps, const Eigen::VectorXd& weight) {
  const Eigen::Index shots = lamps.rows(), count = lamps.cols();
  Eigen::MatrixXd own = Eigen::MatrixXd::Zero(3 * shots, 3 * count);
  for (Eigen::Index k = 0; k < shots; ++k)
    for (Eigen::Index c = 0; c < 3; ++c)
      own.block(3 * k + c, c * count, 1, count) = weight[3 * k + c] * lamps.row(k);
  return own;
}

/// The values that lights can make, nearest to those seen under their weights.
Eigen::VectorXd nearestMade(const Eigen::VectorXd& seen, const Eigen::VectorXd& weight,
                            const Eigen::MatrixXd& directions) {
  const Eigen::VectorXd weighted = seen.cwiseProduct(weight);
  return (weighted - directions * (directions.transpose() * weighted)).cwiseQuotient(weight);
}

Eigen::VectorXd weightsOf(const EstimatorContext& context, const Eigen::VectorXd& expected,
                          double modelError) {
  Eigen::VectorXd weight(expected.size());
  for (Eigen::Index row = 0; row < expected.size(); ++row) {
    const double y = std::max(expected[row], 0.0);
    weight[row] = 1 / std::sqrt(double(context.noise.variance(float(y))) + std::pow(modelError * y, 2));
  }
  return weight;
}

/// A value with the curve taken off, which lies on the photographs as they were taken: the ambient light's,
/// too.
double lightIn(const CapturePixels& pixels, int row, size_t place, double exposure,
               const ToneCorrection& tone) {
  const int channel = row % 3;
  const double light = double(tone(pixels.shots[size_t(row / 3)].plane(channel)[place]));
  return pixels.ambient ? light - exposure * double(tone(pixels.ambient->plane(channel)[place])) : light;
}

}  // namespace

AdditivitySample additivitySample(const CauseContext& context, const std::vector<double>& exposure,
                                  const ToneCorrection& tone, int count, const CauseTuning& tuning) {
  const LightingMatrix& lighting = context.estimator.lighting;
  const int values = 3 * lighting.shots;
  const Eigen::VectorXd even = Eigen::VectorXd::Ones(values);
  Eigen::MatrixXd lamps, evenly;
  AdditivitySample sample;
  for (const bool ambient : {true, false}) {
    lamps = lampsOf(lighting, exposure, ambient);
    evenly = orthogonalComplement(ownOf(lamps, even));
    sample.ambientProof = ambient && evenly.cols() > 0;
    if (evenly.cols() > 0) break;
  }
  if (evenly.cols() == 0) return sample;

  const PlacedPixels pixels = brightPixels(context.signal, lighting.shots, count, tuning);
  const size_t width = size_t(context.signal.pixels().width());
  for (int p = 0; p < pixels.values.run().count; ++p) {
    Eigen::VectorXd seen(values);
    PixelMisfit pixel;
    pixel.x = int(pixels.places[size_t(p)] % width);
    pixel.y = int(pixels.places[size_t(p)] / width);
    for (int row = 0; row < values; ++row)
      seen[row] =
          lightIn(context.signal.pixels(), row, pixels.places[size_t(p)], exposure[size_t(row / 3)], tone);
    pixel.weight = weightsOf(context.estimator, nearestMade(seen, even, evenly), tuning.modelError);
    pixel.directions = orthogonalComplement(ownOf(lamps, pixel.weight));
    pixel.predicted = nearestMade(seen, pixel.weight, pixel.directions);
    pixel.residual = pixel.directions.transpose() * seen.cwiseProduct(pixel.weight);
    if (!pixel.residual.allFinite() || pixel.residual.size() == 0) continue;
    sample.pixels.push_back(std::move(pixel));
  }
  return sample;
}

}  // namespace swaplight
