#include "core/edit/apply/soft_visibility.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"

namespace swaplight {
namespace {

constexpr int kRounds = 3;  // what is left of the first ones' streaks does not show (there, section 5.3)
constexpr int kRowsAtOnce = 16;
constexpr int kColumnsAtOnce = 128;

/// How much of a pixel comes from the one before.
float passed(float all, float silhouette, float silhouetteBefore) {
  return all * (1 - std::max(silhouette, silhouetteBefore));
}

void alongRow(float* v, const float* silhouette, int count, float all) {
  for (int x = 1; x < count; ++x) v[x] += passed(all, silhouette[x], silhouette[x - 1]) * (v[x - 1] - v[x]);
  for (int x = count - 2; x >= 0; --x)
    v[x] += passed(all, silhouette[x], silhouette[x + 1]) * (v[x + 1] - v[x]);
}

/// From the row before (above or below) to this one, columns begin to end.
void toRow(cv::Mat& picture, const cv::Mat& silhouettes, int y, int before, int begin, int end, float all) {
  auto* v = picture.ptr<float>(y);
  const auto* last = picture.ptr<float>(before);
  const auto* here = silhouettes.ptr<float>(y);
  const auto* there = silhouettes.ptr<float>(before);
  for (int x = begin; x < end; ++x) v[x] += passed(all, here[x], there[x]) * (last[x] - v[x]);
}

void spreadOnce(cv::Mat& picture, const cv::Mat& silhouettes, float all) {
  parallelRows(picture.rows, kRowsAtOnce, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      alongRow(picture.ptr<float>(y), silhouettes.ptr<float>(y), picture.cols, all);
  });
  parallelRows(picture.cols, kColumnsAtOnce, [&](int begin, int end) {
    for (int y = 1; y < picture.rows; ++y) toRow(picture, silhouettes, y, y - 1, begin, end, all);
    for (int y = picture.rows - 2; y >= 0; --y) toRow(picture, silhouettes, y, y + 1, begin, end, all);
  });
}

}  // namespace

Image softVisibility(const Image& visibility, const Image& silhouettes, int radius) {
  Image soft = visibility.clone();
  cv::Mat picture(soft.height(), soft.width(), CV_32F, soft.plane(0));
  cv::Mat barriers(silhouettes.height(), silhouettes.width(), CV_32F,
                   const_cast<float*>(silhouettes.plane(0)));
  if (barriers.size() != picture.size())
    cv::resize(barriers, barriers, picture.size(), 0, 0, cv::INTER_LINEAR);
  for (int round = 0; round < kRounds; ++round) {
    // Of one round: all rounds' variances add up to the whole (equation 14).
    const double deviation =
        radius / 2. * std::sqrt(3.) * std::pow(2, kRounds - 1 - round) / std::sqrt(std::pow(4, kRounds) - 1);
    spreadOnce(picture, barriers, static_cast<float>(std::exp(-std::sqrt(2.) / deviation)));
  }
  return soft;
}

}  // namespace swaplight
