#include "core/edit/pool/light_pool.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/quantile.h"
#include "core/edit/pool/cone_edge.h"
#include "core/edit/pool/lamp_fit.h"
#include "core/edit/pool/small_light.h"

namespace swaplight {
namespace {

constexpr int kWidth = 64;  // of the small pictures that are measured: a pool has no detail

// Values known where `weights` are, continued: the mean over the nearest of them, at growing distances.
cv::Mat continuedFrom(const cv::Mat& values, const cv::Mat& weights) {
  cv::Mat sum = cv::Mat::zeros(values.size(), CV_32F);
  cv::Mat count = cv::Mat::zeros(values.size(), CV_32F) + 1e-12;
  double share = 1;
  for (const double sigma : {1.5, 5., 15., 45.}) {
    cv::Mat s;
    cv::Mat c;
    cv::GaussianBlur(values.mul(weights), s, {}, sigma, 0, cv::BORDER_REPLICATE);
    cv::GaussianBlur(weights, c, {}, sigma, 0, cv::BORDER_REPLICATE);
    sum += share * s;
    count += share * c;
    share *= 1e-3;
  }
  return sum / count;
}

// What is found outside the cone, over what the cone would give there.
double bounceOutside(const SmallLight& small, const LightPool& pool) {
  double found = 0;
  double would = 0;
  const cv::Size size = small.ownGrey.size();
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const PicturePlace place = placeOf(x, y, size);
      if (pool.cone->at(place.x, place.y) > 0.02) continue;
      found += 3. * small.ownGrey.at<float>(y, x);
      for (size_t c = 0; c < 3; ++c)
        would += pool.ratio[c].at<float>(y, x) * (pool.alone ? 1. : small.others[c].at<float>(y, x));
    }
  return would > 0 ? std::clamp(found / would, 0., kMostBounce) : 0;
}

// Four standard deviations of where the light is: a disc's diameter.
double widthOf(const cv::Mat& weight) {
  const cv::Moments m = cv::moments(weight);
  if (!(m.m00 > 0)) return 1;
  return 4 * std::sqrt((m.mu20 + m.mu02) / m.m00 / 2) / weight.cols;
}

// 0..1: where the light's own level tells of its pool. Penumbras and the cone's edge do not.
cv::Mat poolWeight(const cv::Mat& seen, const std::optional<LightCone>& cone) {
  cv::Mat weight = seen.clone();
  for (int y = 0; cone && y < seen.rows; ++y)
    for (int x = 0; x < seen.cols; ++x) {
      const PicturePlace place = placeOf(x, y, seen.size());
      weight.at<float>(y, x) *= static_cast<float>(cone->at(place.x, place.y));
    }
  return cv::min(cv::max((weight - 0.6) / 0.3, 0), 1);
}

std::array<cv::Mat, 3> continuedRatio(const SmallLight& small, const cv::Mat& weight) {
  std::array<cv::Mat, 3> ratio;
  for (size_t c = 0; c < 3; ++c)
    cv::exp(continuedFrom(small.logRatio(small.own[c], small.others[c]), weight), ratio[c]);
  return ratio;
}

// Of the pixels where a light shines.
float brightest(const cv::Mat& light, const cv::Mat& weight) {
  std::vector<float> values;
  for (int y = 0; y < light.rows; ++y)
    for (int x = 0; x < light.cols; ++x)
      if (weight.at<float>(y, x) > .5F) values.push_back(light.at<float>(y, x));
  return values.empty() ? 0.F : static_cast<float>(quantile(std::span(values), .98));
}

}  // namespace

LightPool measurePool(const SolvedSet& set, size_t light) {
  const SmallLight small = smallLight(set, light, kWidth);
  const cv::Size size = small.ownGrey.size();
  LightPool pool;
  pool.alone = small.alone();
  const cv::Mat seen = small.seen();
  pool.cone = coneOf(set, light, small);
  const cv::Mat weight = poolWeight(seen, pool.cone);
  pool.width = widthOf(weight.mul(small.ownGrey));
  pool.ratio = continuedRatio(small, weight);
  for (size_t c = 0; c < 3; ++c) pool.most[c] = brightest(small.own[c], weight);
  const auto pixels = gridOf<PoolPixel>(size, [&](const PicturePlace& place, int y, int x) {
    return PoolPixel{place.x, place.y, small.ownGrey.at<float>(y, x), weight.at<float>(y, x)};
  });
  pool.lamp = fitLamp(pixels, pool.cone ? std::optional(pool.cone->meanRadius()) : std::nullopt);
  if (pool.cone) {
    pool.lamp.lobe = 0;
    const cv::Point2d middle = pool.cone->middle();
    pool.lamp.aim = {middle.x, middle.y, 0};
    pool.bounce = bounceOutside(small, pool);
  }
  return pool;
}

}  // namespace swaplight
