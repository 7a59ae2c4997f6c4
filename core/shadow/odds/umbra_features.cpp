#include "core/shadow/odds/umbra_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc/edge_filter.hpp>

#include "core/shadow/numeric/shadow_pictures.h"
#include "core/shadow/odds/shared_reflectance.h"

namespace swaplight {
namespace {

constexpr float kFloor = 3e-4f;                                 // of white: what is darker is all alike
constexpr float kFine = .9f, kCoarse = 2.5f, kStepBlur = 1.8f;  // reference units: blurs
constexpr float kLeastStep = 1e-3f;                             // log, a reference unit: less is none
constexpr double kLit = .95;       // share of the pixels that are not above well-lit ones
constexpr int kWindowPixels = 12;  // radii beyond are looked at in a smaller picture
constexpr double kWidePixels = 8;  // of a blur: wider ones are made in a smaller picture
constexpr std::array kWindows = {5.f, 12.f, 30.f, 75.f};   // reference units
constexpr std::array kSurroundings = {12.f, 35.f, 100.f};  // the same
static_assert(kSurroundings.size() == std::tuple_size_v<decltype(SmallSet::totalAround)>);
constexpr std::array kSurfaceReaches = {30.f, 120.f};  // the same
constexpr double kSurfaceEdge = .8;                    // log step that ends a surface

cv::Mat blurred(const cv::Mat& x, double sigma) {
  cv::Mat out;
  cv::GaussianBlur(x, out, {}, sigma, sigma, cv::BORDER_REPLICATE);
  return out;
}

// The mean of the surroundings as far as `sigma`: where it is wide, of a smaller picture.
cv::Mat surroundings(const cv::Mat& x, double sigma) {
  const cv::Size size = sizeDivided(x.size(), sigma / kWidePixels);
  if (size == x.size()) return blurred(x, sigma);
  return grown(blurred(shrunk(x, size), sigma * size.width / x.cols), x.size());
}

cv::Mat logOf(const cv::Mat& x) {
  cv::Mat out = cv::max(x, 0) + kFloor;
  cv::log(out, out);
  return out;
}

cv::Mat highest(const cv::Mat& x, float radius) {
  cv::Mat out;
  const int factor = std::max(1, static_cast<int>(radius) / kWindowPixels);
  if (factor == 1) {
    cv::dilate(x, out, disk(radius));
    return out;
  }
  const cv::Size size((x.cols + factor - 1) / factor, (x.rows + factor - 1) / factor);
  cv::dilate(shrunk(x, size), out, disk(radius / static_cast<float>(factor)));
  return grown(out, x.size());
}

cv::Mat lowest(const cv::Mat& x, float radius) {
  return -highest(-x, radius);
}

Slopes gentleSlopes(const cv::Mat& x) {
  Slopes slopes;
  cv::Sobel(x, slopes.x, CV_32F, 1, 0, 3, .125, 0, cv::BORDER_REPLICATE);
  cv::Sobel(x, slopes.y, CV_32F, 0, 1, 3, .125, 0, cv::BORDER_REPLICATE);
  return slopes;
}

// The part of a slope that the others' slope does not have.
cv::Mat unsharedSlope(const Slopes& own, const Slopes& others) {
  cv::Mat unshared(own.x.size(), CV_32F);
  for (int y = 0; y < unshared.rows; ++y)
    for (int x = 0; x < unshared.cols; ++x) {
      const float ax = own.x.at<float>(y, x);
      const float ay = own.y.at<float>(y, x);
      const float size2 = ax * ax + ay * ay;
      const float common = ax * others.x.at<float>(y, x) + ay * others.y.at<float>(y, x);
      unshared.at<float>(y, x) = std::clamp(1 - common / std::max(size2, 1e-9f), 0.f, 1.f) * std::sqrt(size2);
    }
  return unshared;
}

struct SurfaceEnds {
  cv::Mat highest, lowest;
};

// Exponential means of a log level along a surface: near the highest for a large power, near the lowest for
// one below 0.
SurfaceEnds endsAlongSurface(const cv::Mat& level, const cv::Mat& guide, double reach) {
  constexpr float kPowers[] = {4, -2};
  cv::Mat raised[2];
  for (int i = 0; i < 2; ++i) cv::exp(kPowers[i] * level, raised[i]);
  cv::Mat both;
  cv::merge(raised, 2, both);
  cv::ximgproc::dtFilter(guide, both, both, reach, kSurfaceEdge);
  cv::split(both, raised);
  for (int i = 0; i < 2; ++i) {
    raised[i] = cv::max(raised[i], 0) + 1e-12;
    cv::log(raised[i], raised[i]);
    raised[i] /= kPowers[i];
  }
  return {raised[0], raised[1]};
}

struct ColourFeatures {
  cv::Mat towardsSet, most;
};

// The light's colour over that of all lights: how far towards the set's own mean colour, and how far at all.
ColourFeatures colourFeatures(const SmallSet& set, size_t light, float unit) {
  cv::Mat colour = logOf(blurred(set.rgb[light], 2 * unit)) - logOf(blurred(set.totalRgb, .9 * unit));
  const cv::Scalar mean = cv::mean(logOf(set.totalRgb));
  const double middle = (mean[0] + mean[1] + mean[2]) / 3;
  ColourFeatures out{cv::Mat(colour.size(), CV_32F), cv::Mat(colour.size(), CV_32F)};
  for (int y = 0; y < colour.rows; ++y)
    for (int x = 0; x < colour.cols; ++x) {
      const cv::Vec3f c = colour.at<cv::Vec3f>(y, x);
      const float level = (c[0] + c[1] + c[2]) / 3;
      float towards = 0, most = 0;
      for (int k = 0; k < 3; ++k) {
        towards += (c[k] - level) * static_cast<float>(mean[k] - middle);
        most = std::max(most, std::abs(c[k] - level));
      }
      out.towardsSet.at<float>(y, x) = towards;
      out.most.at<float>(y, x) = most;
    }
  return out;
}

constexpr std::array<std::string_view, 43> kNames = {
    // Levels.
    "level over lit", "smooth level over lit", "level over brightest", "level over median", "ratio over lit",
    // Near by.
    "highest within 5", "lowest within 5", "highest within 12", "lowest within 12", "highest within 30",
    "lowest within 30", "highest within 75", "lowest within 75", "highest ratio within 5",
    "lowest ratio within 5", "highest ratio within 12", "lowest ratio within 12", "highest ratio within 30",
    "lowest ratio within 30", "highest ratio within 75", "lowest ratio within 75",
    "others' highest within 12",
    // Bounce, and its colour.
    "bounce ratio from 12", "level over mean of 12", "bounce ratio from 35", "level over mean of 35",
    "bounce ratio from 100", "level over mean of 100", "colour towards the set's", "colour",
    // The same surface.
    "highest of surface, 30", "lowest of surface, 30", "highest of surface, 120", "lowest of surface, 120",
    // Steps.
    "unshared step", "step", "unshared step within 10",
    // Without the reflectance.
    "shading over lit", "half shading over lit", "highest shading within 12", "lowest shading within 12",
    "highest shading within 50", "lowest shading within 50"};

// The others' contribution; of a light that is alone, nothing.
struct Others {
  cv::Mat grey, rgb;
  bool none = false;
};

Others othersOf(const SmallSet& set, size_t light) {
  if (set.rgb.size() == 1) return {cv::Mat::zeros(set.total.size(), CV_32F), set.totalRgb, true};
  return {set.total - set.grey[light], set.totalRgb - set.rgb[light]};
}

}  // namespace

SmallSet smallSetOf(const std::vector<cv::Mat>& contributions, cv::Size size) {
  SmallSet set;
  const float unit = static_cast<float>(std::max(size.width, size.height)) / 480;
  std::vector<cv::Mat> logs;
  for (const cv::Mat& contribution : contributions) {
    set.rgb.push_back(shrunk(contribution, size));
    set.grey.push_back(cv::max(greyOf(set.rgb.back()), 0));
    if (set.total.empty()) {
      set.totalRgb = set.rgb.back().clone();
      set.total = set.grey.back().clone();
    } else {
      set.totalRgb += set.rgb.back();
      set.total += set.grey.back();
    }
    logs.push_back(logOf(blurred(set.grey.back(), .9 * unit)));
  }
  set.reflectance = sharedReflectance(logs);
  for (size_t i = 0; i < kSurroundings.size(); ++i)
    set.totalAround[i] = logOf(surroundings(set.total, kSurroundings[i] * unit));
  return set;
}

std::vector<cv::Mat> umbraFeatures(const SmallSet& set, size_t light) {
  const cv::Size size = set.total.size();
  const float unit = referenceUnit(set.total);
  const cv::Mat& own = set.grey[light];
  const Others others = othersOf(set, light);
  std::vector<cv::Mat> out;
  out.reserve(kNames.size());
  const auto add = [&](const cv::Mat& x) { out.push_back(x); };
  const auto logAt = [&](const cv::Mat& x, float sigma) { return logOf(blurred(x, sigma * unit)); };
  const auto othersLog = [&](float sigma) {
    return others.none ? cv::Mat::zeros(size, CV_32F) : logAt(others.grey, sigma);
  };

  // Levels.
  const cv::Mat all = logAt(set.total, kFine);
  const cv::Mat level = logAt(own, kFine);
  const cv::Mat other = othersLog(kFine);
  const cv::Mat ratio = level - other;
  const cv::Mat smooth = logAt(own, kCoarse);
  const cv::Mat smoothRatio = smooth - othersLog(kCoarse);
  const float lit = percentile(smooth, kLit);
  add(level - lit);
  add(smooth - lit);
  add(level - percentile(smooth, .995));
  add(level - percentile(smooth, .5));
  add(ratio - percentile(smoothRatio, kLit));

  // Near by.
  for (const float window : kWindows) {
    add(highest(smooth, window * unit) - level);
    add(level - lowest(smooth, window * unit));
  }
  for (const float window : kWindows) {
    add(highest(smoothRatio, window * unit) - ratio);
    add(ratio - lowest(smoothRatio, window * unit));
  }
  add(highest(other, 12 * unit) - other);

  // Bounce, and its colour.
  for (size_t i = 0; i < kSurroundings.size(); ++i) {
    const cv::Mat above = level - logOf(surroundings(own, kSurroundings[i] * unit));
    add(above - (all - set.totalAround[i]));
    add(above);
  }
  const ColourFeatures colour = colourFeatures(set, light, unit);
  add(colour.towardsSet);
  add(colour.most);

  // The same surface.
  const cv::Mat guide = logOf(blurred(others.rgb, 1.5 * unit));
  for (const float reach : kSurfaceReaches) {
    const cv::Mat above = smooth - lit;
    const SurfaceEnds ends = endsAlongSurface(above, guide, reach * unit);
    add(ends.highest + lit - level);
    add(level - lit - ends.lowest);
  }

  // Steps.
  const Slopes slopes = gentleSlopes(logAt(own, kStepBlur));
  const cv::Mat step = sizeOf(slopes) * unit;
  const cv::Mat unshared = unsharedSlope(slopes, gentleSlopes(othersLog(kStepBlur))) * unit;
  const auto logStep = [](const cv::Mat& x) {
    cv::Mat log = x + kLeastStep;
    cv::log(log, log);
    return log;
  };
  add(logStep(unshared));
  add(logStep(step));
  add(logStep(highest(unshared, 10 * unit)));

  // Without the reflectance.
  const cv::Mat shading = level - set.reflectance;
  const cv::Mat half = level - .5 * set.reflectance;
  add(shading - percentile(shading, kLit));
  add(half - percentile(half, kLit));
  const cv::Mat smoothShading = blurred(shading, 1.5 * unit);
  for (const float window : {12.f, 50.f}) {
    add(highest(smoothShading, window * unit) - shading);
    add(shading - lowest(smoothShading, window * unit));
  }
  return out;
}

std::span<const std::string_view> umbraFeatureNames() {
  return kNames;
}

}  // namespace swaplight
