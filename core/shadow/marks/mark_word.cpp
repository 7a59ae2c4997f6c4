#include "core/shadow/marks/mark_word.h"

#include <algorithm>
#include <cmath>

#include "core/shadow/numeric/shadow_pictures.h"
#include "core/shadow/numeric/surface_distance.h"

namespace swaplight {
namespace {

constexpr float kFarthest = 3;  // powers of e: a word that is so weak says nothing
constexpr float kSure = 3;      // log-odds; more is no more sure, but the noise of large numbers

/// How far a mark's word has to go to each pixel, in powers of e. `cost`: of a step on the surface.
cv::Mat distanceFrom(const ShadowMark& mark, cv::Point at, const cv::Mat& cost, const MarkedSurface& surface,
                     const ShadowMarkTuning& tuning) {
  const auto against = [&](const cv::Mat& lit) {
    return mark.is == ShadowMark::Kind::Lit ? cv::Mat(-lit) : lit;
  };
  const cv::Mat darker = against(surface.shading);
  const cv::Mat wrong = cv::max(darker - (darker.at<float>(at) + tuning.tolerance), 0) / tuning.tolerance;
  if (surface.evidence.empty()) return surfaceDistance(cost, at, kFarthest) + wrong;
  const cv::Mat contrary = cv::min(against(surface.evidence), kSure);
  const cv::Mat resisted = cost + tuning.contrary / referenceUnit(cost) * cv::max(cv::min(contrary, 1), 0);
  const cv::Mat stronger = tuning.stronger * cv::max(contrary - contrary.at<float>(at), 0);
  return surfaceDistance(resisted, at, kFarthest) + wrong + stronger;
}

/// The word of the nearer kind, as strong as it is near, and undecided between the two.
float wordBetween(float shadow, float lit, float shareBy) {
  const float strength = std::exp(-std::min(shadow, lit));
  return strength * std::tanh((shadow - lit) / (2 * shareBy));
}

}  // namespace

cv::Point markedPixel(const ShadowMark& mark, cv::Size picture, cv::Size size) {
  return {static_cast<int>((static_cast<int64_t>(mark.x) * size.width + size.width / 2) / picture.width),
          static_cast<int>((static_cast<int64_t>(mark.y) * size.height + size.height / 2) / picture.height)};
}

cv::Mat wordOfMarks(const ShadowMarks& marks, const MarkedSurface& surface, cv::Size picture,
                    const ShadowMarkTuning& tuning) {
  if (marks.empty()) return {};
  const cv::Size size = surface.shading.size();
  const float unit = referenceUnit(surface.shading);
  MarkedSurface calm = surface;  // a single pixel's noise is not the level of a surface
  cv::GaussianBlur(surface.shading, calm.shading, {}, unit, 0, cv::BORDER_REPLICATE);
  cv::Mat cost = cv::max(surface.borders - tuning.quiet, 0);
  cost = tuning.barrier * cost.mul(cost) + 1 / (tuning.reach * unit);
  cv::Mat toShadow(size, CV_32F, cv::Scalar(kFarthest));
  cv::Mat toLit = toShadow.clone();
  for (const ShadowMark& mark : marks) {
    cv::Mat& nearest = mark.is == ShadowMark::Kind::Lit ? toLit : toShadow;
    const cv::Point at = markedPixel(mark, picture, size);
    nearest = cv::min(nearest, distanceFrom(mark, at, cost, calm, tuning));
  }
  cv::Mat word(size, CV_32F);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      word.at<float>(y, x) = wordBetween(toShadow.at<float>(y, x), toLit.at<float>(y, x), tuning.shareBy);
  for (const ShadowMark& mark : marks)
    word.at<float>(markedPixel(mark, picture, size)) = mark.is == ShadowMark::Kind::Lit ? 1.F : -1.F;
  return word;
}

}  // namespace swaplight
