#include "core/edit/pool/light_pool.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/edit/pool/lamp_fit.h"
#include "core/edit/pool/shrunk_plane.h"

namespace swaplight {
namespace {

constexpr int kWidth = 64;       // of the small pictures that are measured: a pool has no detail
constexpr int kEdgeWidth = 160;  // of those that its cone's edge is measured in
// How much of the light is there, from its ratio to the others over that ratio where the light is: from none
// (bounced light only) to all.
constexpr double kNoLight = 0.04;
constexpr double kAllLight = 0.25;
// The same of its level, where a cone is looked for: where no other light reaches either, bounced light alone
// makes any ratio. From the darkest surfaces that are lit to the brightest that only bounced light reaches.
constexpr double kDarkest = 0.02;
constexpr double kBounced = 0.08;
constexpr double kBenefit = 1.1;       // of the doubt, for a cone's edge as it is seen
constexpr double kFaintOthers = 0.02;  // of their mean: below, a ratio to them says nothing
constexpr double kMostRatio = 400;
constexpr double kMostBounce = 0.2;

struct SmallPictures {
  std::array<cv::Mat, 3> own, others;
  cv::Mat ownGrey, othersGrey;
};

SmallPictures shrunkSet(const SolvedSet& set, size_t light, int most) {
  const int width = std::min(most, set.width());
  const cv::Size size(
      width, std::max(1, static_cast<int>(std::lround(double{1} * set.height() * width / set.width()))));
  const size_t lights = set.contributions.size();
  std::vector<cv::Mat> planes(3 * lights);
  parallelEach(static_cast<int>(planes.size()), [&](int k) {
    planes[static_cast<size_t>(k)] = shrunkPlane(set.contributions[static_cast<size_t>(k) / 3], k % 3, size);
  });
  SmallPictures small;
  for (size_t c = 0; c < 3; ++c) {
    small.own[c] = planes[3 * light + c];
    small.others[c] = cv::Mat::zeros(size, CV_32F);
    for (size_t i = 0; i < lights; ++i)
      if (i != light) small.others[c] += planes[3 * i + c];
  }
  small.ownGrey = (small.own[0] + small.own[1] + small.own[2]) / 3;
  small.othersGrey = (small.others[0] + small.others[1] + small.others[2]) / 3;
  return small;
}

// The median of the values, each counted by its weight.
double weightedMedian(const cv::Mat& values, const cv::Mat& weights) {
  const auto* v = values.ptr<float>();
  const auto* w = weights.ptr<float>();
  std::vector<size_t> order(values.total());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return v[a] < v[b]; });
  const double half = cv::sum(weights)[0] / 2;
  double below = 0;
  for (const size_t p : order) {
    below += w[p];
    if (below >= half) return v[p];
  }
  return 0;
}

// A smooth step up, from none to all of what the light is where it shines.
cv::Mat stepOf(const cv::Mat& light, const SmallPictures& small, double none, double all) {
  const double full = weightedMedian(light, small.ownGrey);
  cv::Mat seen = (light / std::max(full, 1e-12) - none) / (all - none);
  seen = cv::min(cv::max(seen, 0), 1);
  return seen.mul(seen).mul(3 - 2 * seen);
}

// 0..1: how much of the light is there. Ratios to the other lights are free of texture.
cv::Mat seenOf(const SmallPictures& small, bool alone) {
  const double faint = kFaintOthers * cv::mean(small.othersGrey)[0];
  const cv::Mat ratio = alone ? small.ownGrey : cv::Mat(small.ownGrey / cv::max(small.othersGrey, faint));
  return stepOf(ratio, small, kNoLight, kAllLight);
}

// The same, and bright enough for more than bounced light: where a cone may be.
cv::Mat litOf(const SmallPictures& small, const cv::Mat& seen) {
  return cv::min(seen, stepOf(small.ownGrey, small, kDarkest, kBounced));
}

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

struct Place {
  double x, y;
};

// Of a pixel of a small picture.
Place placeOf(int column, int row, const cv::Size& size) {
  return {(column + .5) / size.width - .5, (.5 * size.height - (row + .5)) / size.width};
}

template <typename Pixel, typename Make>
std::vector<Pixel> gridOf(const cv::Size& size, const Make& make) {
  std::vector<Pixel> pixels;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) pixels.push_back(make(placeOf(x, y, size), y, x));
  return pixels;
}

// log of the light over the others (or of the light itself), bounded.
cv::Mat logRatio(const cv::Mat& own, const cv::Mat& others, bool alone) {
  const cv::Mat ratio = alone ? own : cv::Mat((own + 1e-6) / (others + 1e-6));
  cv::Mat logarithm;
  cv::log(cv::min(cv::max(ratio, 1 / kMostRatio), kMostRatio), logarithm);
  return logarithm;
}

// What is found outside the cone, over what the cone would give there.
double bounceOutside(const SmallPictures& small, const LightPool& pool) {
  double found = 0;
  double would = 0;
  const cv::Size size = small.ownGrey.size();
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const Place place = placeOf(x, y, size);
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

std::vector<SeenPixel> pixelsOf(const cv::Mat& seen) {
  return gridOf<SeenPixel>(seen.size(), [&](const Place& place, int y, int x) {
    return SeenPixel{place.x, place.y, seen.at<float>(y, x)};
  });
}

// The outline that is seen, if that tells better what is lit than an ellipse does.
LightCone asSeen(const LightCone& ellipse, const cv::Mat& seen) {
  const std::vector<SeenPixel> pixels = pixelsOf(seen);
  LightCone outlined = ellipse, best = ellipse;
  outlined.outline = ConeOutline::in(seen);
  if (!outlined.outline) return ellipse;
  double least = kBenefit * unexplainedBy(ellipse, pixels);
  for (const double softness : {.05, .1, .2, .4, .8}) {
    outlined.softness = softness;
    const double cost = unexplainedBy(outlined, pixels);
    if (cost < least) {
      least = cost;
      best = outlined;
    }
  }
  return best;
}

// 0..1: where the light's own level tells of its pool. Penumbras and the cone's edge do not.
cv::Mat poolWeight(const cv::Mat& seen, const std::optional<LightCone>& cone) {
  cv::Mat weight = seen.clone();
  for (int y = 0; cone && y < seen.rows; ++y)
    for (int x = 0; x < seen.cols; ++x) {
      const Place place = placeOf(x, y, seen.size());
      weight.at<float>(y, x) *= static_cast<float>(cone->at(place.x, place.y));
    }
  return cv::min(cv::max((weight - 0.6) / 0.3, 0), 1);
}

std::array<cv::Mat, 3> continuedRatio(const SmallPictures& small, bool alone, const cv::Mat& weight) {
  std::array<cv::Mat, 3> ratio;
  for (size_t c = 0; c < 3; ++c)
    cv::exp(continuedFrom(logRatio(small.own[c], small.others[c], alone), weight), ratio[c]);
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

// The light's ratio to the others along the cone's radius: 1 inside, 0 far outside. Shadows lie in it, so
// that of a ring the upper quartile counts. NaN where there are too few pixels.
class ConeProfile {
 public:
  ConeProfile(const SmallPictures& small, const LightCone& cone, bool alone) {
    cv::Mat ratio = logRatio(small.ownGrey, small.othersGrey, alone);
    for (int y = 0; y < ratio.rows; ++y)
      for (int x = 0; x < ratio.cols; ++x) {
        const Place place = placeOf(x, y, ratio.size());
        m_pixels.push_back({cone.radius(place.x, place.y), ratio.at<float>(y, x)});
      }
    std::vector<double> inside = between(0, kInside);
    m_inside = inside.size() < kFewest ? 0 : quantile(std::span(inside), 0.6);
    std::vector<double> outside = between(kOutside, 1e9);
    m_outside = outside.size() < kFewest
                    ? 0
                    : std::min(std::exp(quantile(std::span(outside), 0.5) - m_inside), kMostBounce);
  }
  [[nodiscard]] double at(double radius) const {
    std::vector<double> ring = between(radius - kRing, radius + kRing);
    if (ring.size() < kFewest) return std::nan("");
    return (std::exp(quantile(std::span(ring), 0.75) - m_inside) - m_outside) / (1 - m_outside);
  }

 private:
  static constexpr double kInside = 0.7, kOutside = 1.4, kRing = 0.05;  // radii
  static constexpr size_t kFewest = 6;
  struct AtRadius {
    double radius, logRatio;
  };
  [[nodiscard]] std::vector<double> between(double least, double most) const {
    std::vector<double> found;
    for (const AtRadius& pixel : m_pixels)
      if (pixel.radius >= least && pixel.radius < most) found.push_back(pixel.logRatio);
    return found;
  }
  std::vector<AtRadius> m_pixels;
  double m_inside = 0, m_outside = 0;
};

// A cone that was found by where there is any light at all, with its edge where half of the light is, as soft
// as it is.
LightCone withEdge(LightCone cone, const SmallPictures& small, bool alone) {
  constexpr double kFrom = 0.5;
  constexpr double kTo = 1.65;
  constexpr double kStep = 0.05;
  constexpr double kQuarters =
      0.348;  // of a smooth step's width lie between a quarter and three quarters of it
  const ConeProfile profile(small, cone, alone);
  double full = 0;
  for (double r = kFrom; r < kTo; r += kStep)
    if (profile.at(r) >= 0.75) full = r;
  if (full == 0) return cone;
  for (double r = full + kStep; r < kTo; r += kStep)
    if (profile.at(r) <= 0.25) {
      const double edge = .5 * (full + r);
      cone.softness = std::clamp((r - full) / kQuarters / edge, 0.05, 1.);
      cone.setEdge(edge);
      break;
    }
  return cone;
}

}  // namespace

LightPool measurePool(const SolvedSet& set, size_t light) {
  const SmallPictures small = shrunkSet(set, light, kWidth);
  const cv::Size size = small.ownGrey.size();
  LightPool pool;
  pool.alone = !(cv::sum(small.othersGrey)[0] > 0);
  const cv::Mat seen = seenOf(small, pool.alone);
  pool.cone = findCone(pixelsOf(litOf(small, seen)));
  if (pool.cone) {
    const SmallPictures edges = shrunkSet(set, light, kEdgeWidth);
    pool.cone = withEdge(asSeen(*pool.cone, litOf(edges, seenOf(edges, pool.alone))), edges, pool.alone);
  }
  const cv::Mat weight = poolWeight(seen, pool.cone);
  pool.width = widthOf(weight.mul(small.ownGrey));
  pool.ratio = continuedRatio(small, pool.alone, weight);
  for (size_t c = 0; c < 3; ++c) pool.most[c] = brightest(small.own[c], weight);
  const auto pixels = gridOf<PoolPixel>(size, [&](const Place& place, int y, int x) {
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
