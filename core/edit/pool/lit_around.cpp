#include "core/edit/pool/lit_around.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"
#include "core/edit/pool/small_light.h"

namespace swaplight {
namespace {

constexpr int kLongest = 240;  // pixels of the picture that is looked at
constexpr int kDirections = 24;
constexpr float kLitFrom = .5F;
constexpr float kBeside = .5F;  // of the directions: as many see lit surfaces from beyond all of them
constexpr float kAmong = .75F;
constexpr double kDarkBorder = .4, kLitBorder = .6;  // of the picture's border

/// What is taken to lie beyond the picture: more of the same as most of its border.
float litOutside(const cv::Mat& lit) {
  const cv::Scalar border = cv::sum(lit.row(0)) + cv::sum(lit.row(lit.rows - 1)) + cv::sum(lit.col(0)) +
                            cv::sum(lit.col(lit.cols - 1));
  const double share = border[0] / (2. * (lit.rows + lit.cols));
  return static_cast<float>(std::clamp((share - kDarkBorder) / (kLitBorder - kDarkBorder), 0., 1.));
}

/// Adds to each pixel of `seen` whether something lit is seen from it in one direction: what its neighbour
/// there sees, or is. Of two neighbours that the direction falls between, the mean.
void lookAlong(const cv::Mat& lit, float outside, double angle, cv::Mat& seen) {
  const double dx = std::cos(angle), dy = std::sin(angle);
  const bool level = std::abs(dx) >= std::abs(dy);  // steps of a column; else of a row
  const int steps = level ? lit.cols : lit.rows, across = level ? lit.rows : lit.cols;
  const bool forward = (level ? dx : dy) > 0;
  const double slope = level ? dy / std::abs(dx) : dx / std::abs(dy);
  const int shift = static_cast<int>(std::floor(slope));
  const auto part = static_cast<float>(slope - shift);
  std::vector<float> before(static_cast<size_t>(across) + 4, outside), here(before);
  for (int step = 0; step < steps; ++step) {
    const int at = forward ? steps - 1 - step : step;
    for (int i = 0; i < across; ++i) {
      const auto place = static_cast<size_t>(i + 2 + shift);
      const float there = before[place] + part * (before[place + 1] - before[place]);
      const cv::Point pixel = level ? cv::Point(at, i) : cv::Point(i, at);
      here[static_cast<size_t>(i) + 2] = std::max(there, lit.at<float>(pixel));
      seen.at<float>(pixel) += here[static_cast<size_t>(i) + 2];
    }
    std::swap(before, here);
  }
}

}  // namespace

std::shared_ptr<const Image> litAround(const Image& visibility) {
  const int width = visibility.width(), height = visibility.height();
  const int factor = std::max(1, (std::max(width, height) + kLongest - 1) / kLongest);
  const cv::Size size((width + factor - 1) / factor, (height + factor - 1) / factor);
  cv::Mat lit;
  cv::Mat(shrunkPlane(visibility, 0, size) > kLitFrom).convertTo(lit, CV_32F, 1 / 255.);
  const float outside = litOutside(lit);
  std::array<cv::Mat, kDirections> each;
  parallelEach(kDirections, [&](int k) {
    each[static_cast<size_t>(k)] = cv::Mat::zeros(size, CV_32F);
    lookAlong(lit, outside, 2 * std::numbers::pi * (k + .5) / kDirections, each[static_cast<size_t>(k)]);
  });
  cv::Mat seen = cv::Mat::zeros(size, CV_32F);
  for (const cv::Mat& one : each) seen += one / kDirections;
  seen = cv::min(cv::max((seen - kBeside) / (kAmong - kBeside), 0), 1);
  auto around = std::make_shared<Image>(ImageSpec{width, height, {"Y"}, "data"});
  cv::Mat full(height, width, CV_32F, around->plane(0));
  cv::resize(seen, full, full.size(), 0, 0, cv::INTER_LINEAR);
  return around;
}

}  // namespace swaplight
