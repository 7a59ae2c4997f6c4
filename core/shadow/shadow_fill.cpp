#include "core/shadow/shadow_fill.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc/edge_filter.hpp>

#include "core/shadow/poisson.h"

namespace swaplight {
namespace {

constexpr int kLargestWork = 640;     // pixels across at which the smooth fields are solved
constexpr float kDark = .004f;        // of white: where the other lights say nothing of the surface
constexpr float kSure = .95f;         // visibility of pixels that are fully lit
constexpr float kOtherSure = .7f;     // visibility of pixels that the other lights show well enough
constexpr float kRatioEdge = .3f;     // log step of the other lights that a ratio is not continued over
constexpr float kLeastOfMean = .93f;  // of the ratio around it: less is not fully lit
constexpr float kPictureEdge =
    .5f;                            // log step of the whole picture that a contribution is not continued over
constexpr float kMostlySeen = .2f;  // visibility from which on it is refined
constexpr float kReached = .05f;    // visibility beyond the end of shading that falls off
constexpr float kLeastGrey = 1e-4f;  // of white
constexpr float kFullySeen = .7f;    // visibility from which on the whole contribution counts as direct

cv::Mat greyOf(const cv::Mat& rgb) {
  cv::Mat grey;
  cv::transform(rgb, grey, cv::Matx13f(1 / 3.f, 1 / 3.f, 1 / 3.f));
  return grey;
}

cv::Mat shrunk(const cv::Mat& x, cv::Size size) {
  cv::Mat out;
  cv::resize(x, out, size, 0, 0, cv::INTER_AREA);
  return out;
}

cv::Mat grown(const cv::Mat& x, cv::Size size) {
  cv::Mat out;
  cv::resize(x, out, size, 0, 0, cv::INTER_LINEAR);
  return out;
}

cv::Mat spread(const cv::Mat& gray) {
  cv::Mat rgb;
  cv::merge(std::vector<cv::Mat>(3, gray), rgb);
  return rgb;
}

cv::Mat logarithm(const cv::Mat& x) {
  cv::Mat out = x + cv::Scalar::all(.01);
  cv::log(out, out);
  return out;
}

// Mean of x over the pixels that `mask` (0 or 1, float) chooses, at the working size.
cv::Mat meanOver(const cv::Mat& x, const cv::Mat& mask, cv::Size size) {
  cv::Mat weight = shrunk(mask, size);
  cv::max(weight, 1e-6, weight);
  const cv::Mat sum = shrunk(x.mul(x.channels() == 3 ? spread(mask) : mask), size);
  cv::Mat mean;
  cv::divide(sum, x.channels() == 3 ? spread(weight) : weight, mean);
  return mean;
}

// The local mean of x over `where`, not across the guide's edges (Gastal and Oliveira 2011).
cv::Mat localMean(const cv::Mat& x, const cv::Mat& where, const cv::Mat& guide, double radius) {
  cv::Mat sum, weight;
  cv::ximgproc::dtFilter(guide, x.mul(where), sum, radius, kRatioEdge * 3);
  cv::ximgproc::dtFilter(guide, where, weight, radius, kRatioEdge * 3);
  cv::max(weight, 1e-6, weight);
  return sum / weight;
}

struct Continued {
  cv::Mat ratio;
  cv::Mat cast;  ///< 0..1: is the shadow nearby cast, or does the shading fall off by itself?
};

// A ratio known where `fixed`, continued. Where it fades out towards the border (shading that falls off, not
// a shadow that is cast) what lies beyond is dark of itself: 0.
Continued continued(const cv::Mat& ratio, const cv::Mat& fixed, const cv::Mat& guide) {
  cv::Mat where;
  fixed.convertTo(where, CV_32F, 1 / 255.);
  const double near = std::max(2., ratio.cols / 160.);
  cv::Mat wide = localMean(ratio, where, guide, 5 * near);
  cv::max(wide, 1e-6, wide);
  cv::Mat cast = (localMean(ratio, where, guide, near) / wide - .65) / .2;
  cv::min(cast, 1, cast);
  cv::max(cast, 0, cast);
  // The last of a penumbra would pull the continuation down.
  const cv::Mat full = fixed & ((ratio > kLeastOfMean * wide) | (cast < .5));
  cast = (fillSmoothly(cast, fixed, guide, kRatioEdge) - .4) / .3;
  cv::min(cast, 1, cast);
  cv::max(cast, 0, cast);
  cv::Mat smooth = fillSmoothly(ratio, full, guide, kRatioEdge);
  cv::max(smooth, 0, smooth);
  return {smooth.mul(cast), cast};
}

}  // namespace

FilledShadow fillShadow(const SetEvidence& set, const std::vector<cv::Mat>& visibilities, size_t light) {
  const cv::Mat& own = set.contributions[light];
  const cv::Mat& visibility = visibilities[light];
  const cv::Size full = own.size();
  const int shrink = (std::max(full.width, full.height) + kLargestWork - 1) / kLargestWork;
  const cv::Size size((full.width + shrink - 1) / shrink, (full.height + shrink - 1) / shrink);

  // The other lights and the whole picture.
  cv::Mat others(full, CV_32FC3, cv::Scalar::all(0));
  cv::Mat whole = own.clone();
  cv::Mat seen(full, CV_32F, cv::Scalar(0));
  for (size_t j = 0; j < set.contributions.size(); ++j) {
    if (j == light) continue;
    whole += set.contributions[j];
    others += set.contributions[j];
    seen = cv::max(seen, visibilities[j]);
  }
  const cv::Mat otherGrey = greyOf(others);
  const int rim = std::max(2, full.width / 320);  // the faint end of penumbras
  const auto sureOf = [rim](const cv::Mat& v, float least) {
    cv::Mat sure = v > least;
    cv::erode(sure, sure, {}, {-1, -1}, rim, cv::BORDER_CONSTANT, cv::Scalar(255));
    return sure;
  };
  const cv::Mat known = (otherGrey > kDark) & sureOf(seen, kOtherSure);
  const cv::Mat sure = sureOf(visibility, kSure);
  const cv::Mat inShadow = ~sure;

  // The ratio to the other lights, known where both light the surface, continued into the shadow.
  const auto asFloat = [](const cv::Mat& mask) {
    cv::Mat out;
    mask.convertTo(out, CV_32F, 1 / 255.);
    return out;
  };
  const cv::Mat both = asFloat(sure & known);
  cv::Mat ratio;
  cv::Mat below = shrunk(otherGrey.mul(both), size);
  cv::max(below, 1e-6, below);
  cv::divide(shrunk(greyOf(own).mul(both), size), below, ratio);
  const cv::Mat fixed = shrunk(both, size) > .49;
  const cv::Mat guide = logarithm(meanOver(others, asFloat(known), size));
  const auto [smoothRatio, cast] = continued(ratio, fixed, guide);

  // The contribution without its shadow, coarsely; what no light shows is continued from its surroundings.
  const cv::Mat knownSmall = shrunk(asFloat(known), size) > .49;
  const cv::Mat shadowSmall = shrunk(asFloat(inShadow), size) > .3;
  cv::Mat coarse = shrunk(own, size);
  cv::Mat(spread(smoothRatio).mul(meanOver(others, asFloat(known), size)))
      .copyTo(coarse, shadowSmall & knownSmall);
  const cv::Mat told = ~(shadowSmall & ~knownSmall);
  const cv::Mat picture = logarithm(shrunk(whole, size));
  cv::Mat channels[3];
  cv::split(coarse, channels);
  for (cv::Mat& channel : channels) {
    channel = fillSmoothly(channel, told, picture, kPictureEdge);
    cv::max(channel, 0, channel);
  }
  cv::merge(channels, 3, coarse);

  // In full detail where the other lights have it.
  cv::Mat unshadowed = grown(coarse, full);
  cv::Mat detailed;
  cv::erode(known, detailed, {});
  cv::Mat(spread(grown(smoothRatio, full)).mul(others)).copyTo(unshadowed, detailed);

  cv::Mat missing = unshadowed - own;
  cv::max(missing, 0, missing);
  missing.setTo(cv::Scalar::all(0), sure);

  // Where most of the light arrives, what is missing says how much of it exactly: bounced light counts
  // little.
  FilledShadow filled{cv::Mat(), visibility.clone()};
  const cv::Mat present = greyOf(own) + kLeastGrey;
  cv::Mat seenShare;
  cv::divide(present, present + greyOf(missing), seenShare);
  cv::max(seenShare, kMostlySeen, seenShare);
  cv::min(seenShare, visibility, seenShare);
  seenShare.copyTo(filled.visibility, visibility > kMostlySeen);
  // Shading that falls off by itself is dim, but sees all of the light up to its end.
  cv::Mat reached;
  cv::Mat(visibility > kReached).convertTo(reached, CV_32F, 1 / 255.);
  cv::Mat(reached + grown(cast, full).mul(filled.visibility - reached)).copyTo(filled.visibility, known);
  filled.visibility.setTo(1, sure);

  // Bounced light is no part of it where it can be told apart: in the umbra.
  cv::divide(missing, spread(cv::max(1 - filled.visibility, 1 - kFullySeen)), filled.direct);
  cv::Mat lit = (filled.visibility - kMostlySeen) / (kFullySeen - kMostlySeen);
  cv::min(lit, 1, lit);
  cv::max(lit, 0, lit);
  filled.direct += spread(lit).mul(own + missing - filled.direct);
  return filled;
}

}  // namespace swaplight
