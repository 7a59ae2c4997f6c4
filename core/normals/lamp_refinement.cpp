#include "core/normals/lamp_refinement.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/normals/normal_fit.h"

namespace swaplight {
namespace {

constexpr double kDirectionError = 12;  // degrees: of what a person says
constexpr size_t kFewestPixels = 100;
// How much all pixels together weigh, in single measurements: their errors (bounced light, depth) are alike
// in whole surfaces. Ten times as much did worse under lamps at three widths.
constexpr double kMeasurements = 100;
constexpr int kSteps = 12;
constexpr int kTries = 5;
constexpr double kEnough = 1e-3;  // of the cost: less gain ends the search
constexpr double kDifference = 1e-4;
constexpr Eigen::Index kEach = 3;  // of a lamp: two angles and a level, over their errors

std::vector<TunedLamp> lampsAt(const std::vector<TunedLamp>& told, const Eigen::VectorXd& change,
                               double levelError) {
  std::vector<TunedLamp> lamps = told;
  for (size_t i = 0; i < lamps.size(); ++i) {
    const auto at = change.segment<kEach>(static_cast<Eigen::Index>(i) * kEach);
    LampPlace& place = lamps[i].place;
    // A turn around the vertical is the shorter the higher the lamp; straight above, it is none.
    const double radius = std::max(std::cos(place.elevation * CV_PI / 180), 0.1);
    place.azimuth += kDirectionError * at[0] / radius;
    place.elevation += kDirectionError * at[1];
    lamps[i].level *= std::exp2(levelError * at[2]);
  }
  return lamps;
}

/// The residuals of all pixels, then those of what was said.
Eigen::VectorXd residuals(const std::vector<TunedLamp>& lamps, const std::vector<PixelSights>& pixels,
                          Eigen::Index count, const Eigen::VectorXd& change) {
  std::vector<LampRays> rays;
  for (const TunedLamp& lamp : lamps) rays.emplace_back(lamp.place);
  Eigen::VectorXd all = Eigen::VectorXd::Zero(count + change.size());
  const double weight = std::sqrt(kMeasurements / static_cast<double>(count));
  Eigen::Index next = 0;
  std::vector<LampSight> sights;
  for (const PixelSights& pixel : pixels) {
    sights.clear();
    for (size_t k = 0; k < pixel.lamps.size(); ++k) {
      const LampRay ray = rays[pixel.lamps[k]].at(pixel.x, pixel.y);
      sights.push_back({{ray.direction[0], ray.direction[1], ray.direction[2]},
                        pixel.light[k] / (ray.level * lamps[pixel.lamps[k]].level)});
    }
    const NormalFit fit = fitNormal(sights, 0);
    const double reflectance = std::max(fit.scaled.norm(), 1e-12);
    for (const LampSight& sight : sights) {
      // What lamps that have come to stand alike cannot tell counts as an outlier: no way to a lower cost.
      const double off = (sight.light - sight.direction.dot(fit.scaled)) / reflectance / kOutlier;
      all[next++] = fit.known() ? weight * off / std::sqrt(1 + off * off) : weight;
    }
  }
  all.tail(change.size()) = change;
  return all;
}

}  // namespace

std::vector<TunedLamp> refinedLamps(const std::vector<TunedLamp>& told,
                                    const std::vector<PixelSights>& pixels, double levelError) {
  std::vector<PixelSights> telling;
  Eigen::Index count = 0;
  for (const PixelSights& pixel : pixels)
    if (pixel.lamps.size() > kFewestLamps) {
      telling.push_back(pixel);
      count += static_cast<Eigen::Index>(pixel.lamps.size());
    }
  if (telling.size() < kFewestPixels) return told;

  const auto at = [&](const Eigen::VectorXd& change) {
    return residuals(lampsAt(told, change, levelError), telling, count, change);
  };
  const Eigen::Index size = static_cast<Eigen::Index>(told.size()) * kEach;
  Eigen::VectorXd change = Eigen::VectorXd::Zero(size);
  Eigen::VectorXd error = at(change);
  double damping = 1e-2;
  for (int step = 0; step < kSteps; ++step) {
    Eigen::MatrixXd slopes(error.size(), size);
    for (Eigen::Index k = 0; k < size; ++k)
      slopes.col(k) = (at(change + kDifference * Eigen::VectorXd::Unit(size, k)) - error) / kDifference;
    const Eigen::MatrixXd square = slopes.transpose() * slopes;
    const double cost = error.squaredNorm();
    double gain = 0;
    for (int tried = 0; tried < kTries && gain <= 0; ++tried) {
      Eigen::MatrixXd damped = square;
      damped.diagonal() *= 1 + damping;
      const Eigen::VectorXd next = change - damped.ldlt().solve(slopes.transpose() * error);
      const Eigen::VectorXd nextError = at(next);
      gain = cost - nextError.squaredNorm();
      damping *= gain > 0 ? 0.2 : 5;
      if (gain > 0) {
        change = next;
        error = nextError;
      }
    }
    if (gain <= kEnough * cost) break;
  }
  return lampsAt(told, change, levelError);
}

}  // namespace swaplight
