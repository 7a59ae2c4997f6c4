#include "core/solve/registration/part_shifts.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <opencv2/video/tracking.hpp>
#include <span>

#include "core/base/quantile.h"

namespace swaplight {
namespace {

constexpr int kParts = 4;          // across and down
constexpr int kSmallestPart = 24;  // pixels of its sides
constexpr int kLargestPart = 256;
constexpr size_t kFewestParts = 4;   // that tell a spread
constexpr size_t kFewestTurned = 8;  // that tell a turn
constexpr int kRounds = 10;          // of the robust fit
constexpr float kTukey = 4.685F;     // spreads beyond which a part counts for nothing
constexpr float kFinest = 0.01F;     // pixels: parts that agree better are all as good

/// A shift as a map of places, of a part whose corner lies at `corner` from the middle of the picture.
cv::Mat warpOf(const ShotShift& shift, cv::Point2f corner) {
  const float cosine = shift.zoom * std::cos(shift.turn), sine = shift.zoom * std::sin(shift.turn);
  const float x = shift.x + (cosine - 1) * corner.x - sine * corner.y;
  const float y = shift.y + sine * corner.x + (cosine - 1) * corner.y;
  return cv::Mat_<float>(2, 3) << cosine, -sine, x, sine, cosine, y;
}

/// Where the fitted shift would have a part.
PartShift placedBy(const ShotShift& shift, const PartShift& part) {
  const cv::Mat warp = warpOf(shift, {part.u, part.v});
  return {part.u, part.v, warp.at<float>(0, 2), warp.at<float>(1, 2)};
}

float spreadOf(std::vector<float> values) {
  for (float& value : values) value = std::abs(value);
  return 1.4826F * median(std::span(values));
}

}  // namespace

double improveTranslation(const cv::Mat& first, const cv::Mat& shot, cv::Mat& warp) {
  return cv::findTransformECC(first, shot, warp, cv::MOTION_TRANSLATION,
                              {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 60, 1e-5}, cv::noArray(), 5);
}

std::vector<PartShift> partShifts(const cv::Mat& first, const cv::Mat& shot, const ShotShift& start) {
  const cv::Size size(std::min(first.cols / kParts, kLargestPart),
                      std::min(first.rows / kParts, kLargestPart));
  std::vector<PartShift> parts;
  if (std::min(size.width, size.height) < kSmallestPart) return parts;
  const cv::Point2f middle(float(first.cols - 1) / 2, float(first.rows - 1) / 2);
  for (int i = 0; i < kParts * kParts; ++i) {
    const cv::Point center((2 * (i % kParts) + 1) * first.cols / (2 * kParts),
                           (2 * (i / kParts) + 1) * first.rows / (2 * kParts));
    const cv::Rect area(center - cv::Point(size.width / 2, size.height / 2), size);
    const cv::Point2f corner = cv::Point2f(area.tl()) - middle;
    cv::Mat warp = warpOf(start, corner);
    try {
      if (!(improveTranslation(first(area), shot(area), warp) > kLeastAgreement)) continue;
    } catch (const cv::Exception&) {
      continue;  // nothing to see there
    }
    // What the part's middle has moved by.
    const float u = float(size.width - 1) / 2, v = float(size.height - 1) / 2;
    const float x = warp.at<float>(0, 0) * u + warp.at<float>(0, 1) * v + warp.at<float>(0, 2) - u;
    const float y = warp.at<float>(1, 0) * u + warp.at<float>(1, 1) * v + warp.at<float>(1, 2) - v;
    parts.push_back({corner.x + u, corner.y + v, x, y});
  }
  return parts;
}

void measureSpread(const std::vector<PartShift>& parts, ShotShift& shift) {
  if (parts.size() < kFewestParts) return;
  std::vector<float> x, y;
  for (const PartShift& part : parts) {
    const PartShift placed = placedBy(shift, part);
    x.push_back(part.x - placed.x);
    y.push_back(part.y - placed.y);
  }
  shift.spreadX = spreadOf(std::move(x));
  shift.spreadY = spreadOf(std::move(y));
}

ShotShift fittedShift(const std::vector<PartShift>& parts) {
  ShotShift shift{0, 0, false};
  if (parts.size() < kFewestTurned) return shift;
  std::vector<double> weights(parts.size(), 1);
  for (int round = 0; round < kRounds; ++round) {
    // x = a + c u - d v, y = b + c v + d u: linear in a shift, and in a turn and zoom together.
    Eigen::Matrix4d normal = Eigen::Matrix4d::Identity() * 1e-9;
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (size_t j = 0; j < parts.size(); ++j) {
      const auto& [u, v, x, y] = parts[j];
      const Eigen::Vector4d across(1, 0, u, -v), down(0, 1, v, u);
      normal += weights[j] * (across * across.transpose() + down * down.transpose());
      right += weights[j] * (across * double(x) + down * double(y));
    }
    const Eigen::Vector4d found = normal.ldlt().solve(right);
    shift = {float(found[0]), float(found[1])};
    shift.turn = float(std::atan2(found[3], 1 + found[2]));
    shift.zoom = float(std::hypot(1 + found[2], found[3]));
    measureSpread(parts, shift);
    const float spread = std::max({shift.spreadX, shift.spreadY, kFinest});
    for (size_t j = 0; j < parts.size(); ++j) {
      const PartShift placed = placedBy(shift, parts[j]);
      const double t = double(std::hypot(parts[j].x - placed.x, parts[j].y - placed.y) / (kTukey * spread));
      weights[j] = t < 1 ? (1 - t * t) * (1 - t * t) : 0;
    }
  }
  return shift;
}

bool surelyTurned(const ShotShift& fitted, const std::vector<PartShift>& parts) {
  if (!fitted.found || parts.size() < kFewestTurned) return false;
  double squares = 0;
  for (const PartShift& part : parts) {
    const PartShift placed = placedBy(fitted, part);
    squares += std::pow(double(placed.x - fitted.x), 2) + std::pow(double(placed.y - fitted.y), 2);
  }
  const double displaced = std::sqrt(squares / double(parts.size()));
  const double spread = std::hypot(double(fitted.spreadX), double(fitted.spreadY));
  return displaced > double(kWorthPixels) && displaced > double(kBeyondSpread) * spread;
}

}  // namespace swaplight
