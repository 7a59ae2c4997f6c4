#include "core/illumination/light_sinks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <span>

#include "core/base/quantile.h"
#include "core/illumination/peaks.h"
#include "core/illumination/small_lights.h"

namespace swaplight {
namespace {

constexpr int kSinkWidth = 128;     // pixels: a pool has no detail beyond
constexpr double kFinest = 0.06;    // widths of the picture
constexpr double kBroadest = 0.25;  // widths of the picture
constexpr double kScaleStep = 1.4;
constexpr double kStop = std::numbers::ln2;
// Of the first pool: light that differs by less is even. Of others: shadows and turned surfaces make lesser
// ones (chosen on random_1, 3, 7, 8 and 10 of the rendered sets).
constexpr double kLeastFirst = kStop;
constexpr double kLeastOther = 2.5 * kStop;
constexpr double kSigmas = 5;
constexpr double kFloor = 0.02;  // of the bright part of the light
constexpr double kPlane = 0.15;  // widths: how far a slope at the border is looked for
constexpr double kDark = 1e-12;

cv::Mat logLightOf(const Image& map) {
  const int columns = std::min(kSinkWidth, map.width());
  const cv::Size size(columns, std::max(1L, std::lround(1. * map.height() * columns / map.width())));
  const cv::Mat whole(map.height(), map.width(), CV_32F, const_cast<float*>(map.plane(0)));
  cv::Mat light;
  cv::resize(whole, light, size, 0, 0, cv::INTER_AREA);
  const double floor = kFloor * quantileOf(light, 0.95);
  if (!(floor > kDark)) return {};
  cv::log(cv::max(light, 0) + floor, light);
  return light;
}

cv::Mat smoothed(const cv::Mat& x, double sigma) {
  cv::Mat smooth;
  cv::GaussianBlur(x, smooth, {}, sigma, 0, cv::BORDER_REFLECT);  // a pool at the border is half of one
  return smooth;
}

// Of what differs from pixel to pixel: noise, and texture that was left. A Laplacian of white noise has
// twenty times its variance.
double noiseOf(const cv::Mat& light) {
  cv::Mat laplacian;
  cv::Laplacian(light, laplacian, CV_32F, 1, 1, 0, cv::BORDER_REPLICATE);
  const cv::Mat size = cv::abs(laplacian);
  return 1.4826 * quantileOf(size, 0.5) / std::sqrt(20.);
}

double responseAt(const cv::Mat& light, const Peak& peak, double sigma) {
  cv::Mat laplacian;
  cv::Laplacian(smoothed(light, sigma), laplacian, CV_32F, 1, 1, 0, cv::BORDER_REPLICATE);
  return -sigma * sigma * laplacian.at<float>(peak.y, peak.x);
}

// A Gaussian pool a times e^-r^2/2t^2 answers with 2 a t^2 s^2 / (t^2 + s^2)^2, at most a / 2, where s = t.
void measureScale(const cv::Mat& light, const Peak& peak, double noise, LightSink& sink) {
  double best = 0;
  for (double sigma = kFinest * light.cols; sigma <= kBroadest * light.cols * 1.001; sigma *= kScaleStep) {
    const double response = responseAt(light, peak, sigma);
    if (response <= best) continue;
    best = response;
    sink.radius = sigma;
    sink.sigmas = response * sigma * std::sqrt(2 * std::numbers::pi) / std::max(noise, 1e-6);
  }
  sink.stops = 2 * best / kStop;
}

// The place of a maximum between pixels: of the parabola through it and its neighbours.
double between(double before, double at, double after) {
  const double bend = before - 2 * at + after;
  return bend < 0 ? std::clamp(.5 * (before - after) / bend, -.5, .5) : 0;
}

void place(const cv::Mat& light, const Peak& peak, LightSink& sink) {
  const auto at = [&](int x, int y) {
    return double{light.at<float>(std::clamp(y, 0, light.rows - 1), std::clamp(x, 0, light.cols - 1))};
  };
  const int x = peak.x;
  const int y = peak.y;
  sink.x = x + between(at(x - 1, y), at(x, y), at(x + 1, y));
  sink.y = y + between(at(x, y - 1), at(x, y), at(x, y + 1));
}

// Where the light goes on rising, from the plane through what lies around.
LightSink::Direction slopeAt(const cv::Mat& light, const Peak& peak, const cv::Point& outwards) {
  const int reach = std::max(1, static_cast<int>(kPlane * light.cols));
  const cv::Rect around = cv::Rect(peak.x - reach, peak.y - reach, 2 * reach + 1, 2 * reach + 1) &
                          cv::Rect(0, 0, light.cols, light.rows);
  cv::Mat gx;
  cv::Mat gy;
  cv::Sobel(light, gx, CV_32F, 1, 0, 3, 1, 0, cv::BORDER_REPLICATE);
  cv::Sobel(light, gy, CV_32F, 0, 1, 3, 1, 0, cv::BORDER_REPLICATE);
  double x = cv::mean(gx(around))[0];
  double y = cv::mean(gy(around))[0];
  // Light never falls off towards the border that its pool lies at.
  if (outwards.x != 0) x = outwards.x * std::max(outwards.x * x, 0.);
  if (outwards.y != 0) y = outwards.y * std::max(outwards.y * y, 0.);
  const double length = std::hypot(x, y);
  if (length > 0) return {x / length, y / length};
  const double straight = std::hypot(outwards.x, outwards.y);
  return {outwards.x / straight, outwards.y / straight};
}

cv::Point borderAt(const cv::Mat& light, const Peak& peak) {
  const auto side = [](int at, int last) { return last < 2 ? 0 : at <= 0 ? -1 : at >= last ? 1 : 0; };
  return {side(peak.x, light.cols - 1), side(peak.y, light.rows - 1)};
}

LightSink sinkAt(const cv::Mat& light, const cv::Mat& smooth, const Peak& peak, double noise) {
  LightSink sink;
  sink.prominence = peak.prominence / kStop;
  measureScale(light, peak, noise, sink);
  place(smooth, peak, sink);
  if (const cv::Point border = borderAt(light, peak); border != cv::Point())
    sink.outside = slopeAt(smooth, peak, border);
  return sink;
}

// The small picture's sides are rounded each by itself.
void toPixels(LightSink& sink, double across, double down) {
  sink.x = (sink.x + .5) * across;
  sink.y = (sink.y + .5) * down;
  sink.radius *= across;
}

}  // namespace

std::vector<LightSink> findSinks(const Image& map) {
  const cv::Mat light = logLightOf(map);
  if (light.empty()) return {};
  const double sigma = std::max(kFinest * light.cols, 0.5);
  const cv::Mat smooth = smoothed(light, sigma);
  const double noise = noiseOf(light);
  const double error = noise / (2 * sigma * std::sqrt(std::numbers::pi));  // of a mean under the Gaussian
  std::vector<LightSink> sinks;
  for (const Peak& peak : peaksOf(smooth)) {
    const double least = sinks.empty() ? kLeastFirst : kLeastOther;
    if (peak.prominence < std::max(least, kSigmas * error)) break;
    sinks.push_back(sinkAt(light, smooth, peak, noise));
    toPixels(sinks.back(), 1. * map.width() / light.cols, 1. * map.height() / light.rows);
  }
  return sinks;
}

size_t lampCount(const std::vector<LightSink>& sinks, const Image& map) {
  const bool dark =
      std::all_of(map.plane(0), map.plane(0) + map.pixelCount(), [](float y) { return y == 0; });
  return dark ? 0 : std::max(sinks.size(), size_t{1});
}

}  // namespace swaplight
