#include "core/solve/causes/cause_slopes.h"

#include <algorithm>
#include <cmath>

#include "core/base/quantile.h"

namespace swaplight {
namespace {

constexpr int kToneTerms = 3;
constexpr int kMoveTerms = 4;
constexpr int kAmbientTerms = 3;
constexpr double kDarkest = 1e-5;  // of full scale: where a tone curve is no longer looked at
constexpr double kCoding = 1 / 2.2;

Eigen::Vector3d toneTerms(double y) {
  const double bounded = std::max(y, kDarkest);
  const double v = std::pow(bounded, kCoding);
  return {std::log(bounded), v - 1, v * v - 1};
}

Eigen::MatrixXd colorSlope(const CauseModel& model, const PixelMisfit& pixel) {
  const LightingMatrix& lighting = model.context->lighting;
  Eigen::MatrixXd change = Eigen::MatrixXd::Zero(3 * lighting.shots, model.unknowns);
  for (int k = 0; k < lighting.shots; ++k)
    for (int i = 0; i < lighting.lights; ++i)
      for (int c = 0; c < 3; ++c)
        change(3 * k + c, (k * lighting.lights + i) * 3 + c) =
            double(lighting.color(k, i)[c] * pixel.share[size_t(i)] * pixel.reflectance[c]);
  return change;
}

Eigen::MatrixXd ambientSlope(const CauseModel& model, const PixelMisfit& pixel) {
  Eigen::MatrixXd change = Eigen::MatrixXd::Zero(pixel.predicted.size(), model.unknowns);
  double mean = 0;
  for (const float rho : pixel.reflectance) mean += double(rho) / 3;
  const double level = pixel.predicted.mean();
  for (Eigen::Index row = 0; row < change.rows(); ++row) {
    const Eigen::Index c = row % 3;
    const double hue = mean > 0 ? double(pixel.reflectance[c]) / mean : 1;
    change(row, c) = hue * level;
    change(row, 3 + c) = hue * model.typical;
    change(row, 6 + c) = model.typical;
  }
  return change;
}

Eigen::MatrixXd toneSlope(const CauseModel& model, const PixelMisfit& pixel) {
  Eigen::MatrixXd change(pixel.predicted.size(), model.unknowns);
  for (Eigen::Index row = 0; row < change.rows(); ++row)
    change.row(row) = pixel.predicted[row] * toneTerms(pixel.predicted[row]).transpose();
  return change;
}

/// Place in the picture, the half width being 1.
Eigen::Vector2d placeOf(const CauseModel& model, const PixelMisfit& pixel) {
  const double half = .5 * model.pixels->width();
  return {(pixel.x - half) / half, (pixel.y - .5 * model.pixels->height()) / half};
}

/// The gradient of a shot over 3 x 3 pixels; 0 where one of them is broken.
Eigen::Vector2d gradientAt(const Image& shot, int channel, int x, int y) {
  double across = 0, down = 0;
  const auto at = [&](int u, int v) {
    return double(
        shot.view().at(channel, std::clamp(u, 0, shot.width() - 1), std::clamp(v, 0, shot.height() - 1)));
  };
  for (int j = -1; j <= 1; ++j) {
    across += (at(x + 1, y + j) - at(x - 1, y + j)) / 6;
    down += (at(x + j, y + 1) - at(x + j, y - 1)) / 6;
  }
  if (!std::isfinite(across) || !std::isfinite(down)) return {0, 0};
  return {across, down};
}

Eigen::MatrixXd movedSlope(const CauseModel& model, const PixelMisfit& pixel) {
  Eigen::MatrixXd change = Eigen::MatrixXd::Zero(pixel.predicted.size(), model.unknowns);
  const Eigen::Vector2d place = placeOf(model, pixel);
  for (int k = 1; k < model.context->lighting.shots; ++k)
    for (int c = 0; c < 3; ++c) {
      const Eigen::Vector2d g = gradientAt(model.pixels->shots[size_t(k)], c, pixel.x, pixel.y);
      change.block<1, kMoveTerms>(3 * k + c, kMoveTerms * (k - 1)) << -g.x(), -g.y(),
          g.x() * place.y() - g.y() * place.x(), -g.dot(place);
    }
  return change;
}

Eigen::Vector3d fieldTerms(const Eigen::Vector2d& place) {
  return {place.x(), place.y(), place.squaredNorm()};
}

Eigen::MatrixXd fieldSlope(const CauseModel& model, const PixelMisfit& pixel) {
  const LightingMatrix& lighting = model.context->lighting;
  Eigen::MatrixXd change = Eigen::MatrixXd::Zero(pixel.predicted.size(), model.unknowns);
  const Eigen::RowVector3d terms = fieldTerms(placeOf(model, pixel)).transpose();
  for (int k = 0; k < lighting.shots; ++k)
    for (int i = 0; i < lighting.lights; ++i)
      for (int c = 0; c < 3; ++c)
        change.block<1, kFieldTerms>(3 * k + c, kFieldTerms * (3 * i + c)) =
            double(lighting.color(k, i)[c] * pixel.share[size_t(i)] * pixel.reflectance[c]) * terms;
  return change;
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / double(std::max<size_t>(values.size(), 1)));
}

/// How far the pixels moved, RMS over the sample and the shots.
double movedSize(const CauseModel& model, const Eigen::VectorXd& unknowns,
                 const std::vector<PixelMisfit>& sample) {
  std::vector<double> moved;
  for (const PixelMisfit& pixel : sample) {
    const Eigen::Vector2d place = placeOf(model, pixel);
    for (Eigen::Index j = 0; j < unknowns.size(); j += kMoveTerms) {
      moved.push_back(
          std::hypot(unknowns[j] - unknowns[j + 2] * place.y() + unknowns[j + 3] * place.x(),
                     unknowns[j + 1] + unknowns[j + 2] * place.x() + unknowns[j + 3] * place.y()));
    }
  }
  return rms(moved);
}

double fieldSize(const CauseModel& model, const Eigen::VectorXd& unknowns,
                 const std::vector<PixelMisfit>& sample) {
  std::vector<double> errors;
  for (const PixelMisfit& pixel : sample) {
    const Eigen::Vector3d terms = fieldTerms(placeOf(model, pixel));
    for (Eigen::Index j = 0; j < unknowns.size(); j += kFieldTerms)
      errors.push_back(terms.dot(unknowns.segment<kFieldTerms>(j)));
  }
  return rms(errors);
}

/// The curve's rise in log light over the range that the sample has, less 1.
double toneSize(const Eigen::VectorXd& unknowns, const std::vector<PixelMisfit>& sample) {
  std::vector<double> levels;
  for (const PixelMisfit& pixel : sample) levels.push_back(std::max(pixel.predicted.mean(), kDarkest));
  if (levels.empty()) return 0;
  const double low = quantile(std::span(levels), .1);
  const double high = std::max(quantile(std::span(levels), .9), 1.1 * low);
  return (toneGain(unknowns, high) - toneGain(unknowns, low)) / std::log(high / low);
}

}  // namespace

std::vector<CauseModel> causeModels(const EstimatorContext& context, const ShotSignal& signal,
                                    const std::vector<PixelMisfit>& sample) {
  std::vector<double> levels;
  for (const PixelMisfit& pixel : sample) levels.push_back(pixel.predicted.mean());
  const double typical = levels.empty() ? 0 : median(std::span(levels));
  const LightingMatrix& lighting = context.lighting;
  const auto model = [&](Cause cause, int unknowns, double prior, auto slope) {
    return CauseModel{cause, unknowns, prior, slope, &context, &signal.pixels(), typical};
  };
  return {model(Cause::Colors, 3 * lighting.shots * lighting.lights, .1, colorSlope),
          model(Cause::Ambient, 3 * kAmbientTerms, 1, ambientSlope),
          model(Cause::Tone, kToneTerms, 2, toneSlope),
          model(Cause::Moved, kMoveTerms * (lighting.shots - 1), 3, movedSlope),
          model(Cause::Field, 3 * kFieldTerms * lighting.lights, .2, fieldSlope)};
}

Eigen::MatrixXd visibleSlopes(const CauseModel& model, const std::vector<PixelMisfit>& sample,
                              const MisfitRows& rows) {
  Eigen::MatrixXd slopes(rows.residual.size(), model.unknowns);
  for (size_t p = 0; p < sample.size(); ++p)
    slopes.middleRows(rows.first[p], sample[p].residual.size()) = sample[p].visible(model.change(sample[p]));
  return slopes;
}

Eigen::VectorXd evenAmbientSlope(const Eigen::MatrixXd& slopes) {
  return slopes.middleCols<3>(3).rowwise().sum();
}

int mostCauseUnknowns(const LightingMatrix& lighting) {
  return std::max({3 * lighting.shots * lighting.lights, 3 * kAmbientTerms, kMoveTerms * (lighting.shots - 1),
                   3 * kFieldTerms * lighting.lights});
}

double toneGain(const Eigen::VectorXd& unknowns, double y) {
  return toneTerms(y).dot(unknowns);
}

std::vector<MovedUnknowns> movedUnknowns(const CauseModel& model, const Eigen::VectorXd& unknowns) {
  const double half = .5 * model.pixels->width();
  std::vector<MovedUnknowns> shots;
  for (Eigen::Index j = 0; j < unknowns.size(); j += kMoveTerms)
    shots.push_back({unknowns[j], unknowns[j + 1], unknowns[j + 2] / half, unknowns[j + 3] / half});
  return shots;
}

double causeSize(const CauseModel& model, const Eigen::VectorXd& unknowns,
                 const std::vector<PixelMisfit>& sample) {
  switch (model.cause) {
    case Cause::Moved:
      return movedSize(model, unknowns, sample);
    case Cause::Field:
      return fieldSize(model, unknowns, sample);
    case Cause::Tone:
      return toneSize(unknowns, sample);
    case Cause::Ambient:
    case Cause::Colors:
      break;
  }
  return std::sqrt(unknowns.array().square().mean());
}

}  // namespace swaplight
