#include "core/edit/pool/lamp_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/quantile.h"

namespace swaplight {
namespace {

using Parameters = cv::Vec4d;  // x, y, log z, log of the level

// What is likely before anything was seen: widths of the picture, logarithms.
const Parameters kLikely(0, 0, std::log(0.8), 0);
const Parameters kLikelySpread(1, 1, 0.5, 10);
// Of a lamp with a cone: how far it is over the cone's radius there (a cone of 44 degrees; the spread allows
// for 27 to 67), and how much less is known of the distance itself: spots hang near a background and far from
// a stage.
constexpr double kConeReach = 2.5;
constexpr double kConeReachSpread = 0.5;
constexpr double kSpotSpread = 0.8;
// Texture is a factor of 1.6 or so, and about forty neighbours (of 64 x 36) share theirs.
constexpr double kTexture = 0.5;
constexpr double kAlike = 40;
constexpr double kLeastScale = 0.05;  // of the residuals
constexpr double kLongestStep = 0.3;
constexpr int kMostSteps = 40;
constexpr double kDark = 0.02;  // of the mean: noise from here on
// Where lamps point that light the set evenly: at who stands in the middle, which is a little below that of
// the picture.
const cv::Vec3d kSubject(0, -0.1, 0);

double squareTo(const Parameters& p, const PoolPixel& at) {
  const double dx = at.x - p[0];
  const double dy = at.y - p[1];
  return dx * dx + dy * dy + std::exp(2 * p[2]);
}

double residual(const Parameters& p, const PoolPixel& at) {
  return std::log(at.light) - (p[3] + 3 * p[2] - 1.5 * std::log(squareTo(p, at)));
}

double residualScale(const Parameters& p, const std::vector<PoolPixel>& pixels) {
  std::vector<double> all;
  for (const PoolPixel& at : pixels)
    if (at.weight > 0.5) all.push_back(std::abs(residual(p, at)));
  if (all.empty()) return kTexture;
  return std::max(1.5 * median(std::span(all)), kLeastScale);
}

// One damped step of Gauss and Newton.
Parameters stepFrom(const Parameters& p, const Parameters& likely, const Parameters& likelySpread,
                    const std::vector<PoolPixel>& pixels) {
  const double scale = residualScale(p, pixels);
  cv::Matx44d normal = cv::Matx44d::zeros();
  cv::Vec4d right(0, 0, 0, 0);
  for (const PoolPixel& at : pixels) {
    const double r = residual(p, at);
    const double q = squareTo(p, at);
    const double robust = at.weight / (1 + (r / scale) * (r / scale)) / (kAlike * kTexture * kTexture);
    const cv::Vec4d slope(3 * (at.x - p[0]) / q, 3 * (at.y - p[1]) / q, 3 * (1 - std::exp(2 * p[2]) / q), 1);
    normal += robust * slope * slope.t();
    right += robust * r * slope;
  }
  for (int i = 0; i < 4; ++i) {
    const double precision = 1 / (likelySpread[i] * likelySpread[i]);
    normal(i, i) = (normal(i, i) + precision) * 1.001;
    right[i] += precision * (likely[i] - p[i]);
  }
  Parameters step = normal.solve(right, cv::DECOMP_CHOLESKY);
  for (int i = 0; i < 4; ++i) step[i] = std::clamp(step[i], -kLongestStep, kLongestStep);
  return step;
}

}  // namespace

LampModel fitLamp(std::span<const PoolPixel> pixels, std::optional<double> coneRadius) {
  double weight = 0;
  double light = 0;
  for (const PoolPixel& at : pixels) {
    weight += at.weight;
    light += at.weight * std::max(at.light, 0.);
  }
  LampModel lamp;
  lamp.aim = kSubject;
  if (!(light > 0)) return lamp;  // it is dark
  const double mean = light / weight;

  std::vector<PoolPixel> bright;
  double level = 0;
  double count = 0;
  for (const PoolPixel& at : pixels) {
    if (!(at.light > kDark * mean) || !(at.weight > 0)) continue;
    bright.push_back({at.x, at.y, at.light / mean, at.weight});
    level += at.weight * std::log(at.light / mean);
    count += at.weight;
  }
  Parameters likely = kLikely, likelySpread = kLikelySpread;
  likely[3] = level / count;
  if (coneRadius) {
    const double own = 1 / (kSpotSpread * kSpotSpread);
    const double byCone = 1 / (kConeReachSpread * kConeReachSpread);
    likely[2] = (own * kLikely[2] + byCone * std::log(kConeReach * *coneRadius)) / (own + byCone);
    likelySpread[2] = 1 / std::sqrt(own + byCone);
  }
  Parameters p = likely;
  for (int i = 0; i < kMostSteps; ++i) {
    const Parameters step = stepFrom(p, likely, likelySpread, bright);
    p += step;
    if (cv::norm(step, cv::NORM_INF) < 1e-4) break;
  }
  lamp.position = {p[0], p[1], std::exp(p[2])};
  return lamp;
}

}  // namespace swaplight
