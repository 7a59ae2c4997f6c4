#include "core/shadow/evidence/other_lights.h"

#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {
namespace {

constexpr double kFew = 1e-5;        // of all pixels around: so few that are lit say nothing
constexpr double kSmoothPixels = 5;  // a blur's standard deviation: as exact as more, and a wide one is slow

}  // namespace

OtherLights otherLights(const SetEvidence& set, const std::vector<cv::Mat>& visibilities, size_t light,
                        int rim, const OtherLightsTuning& tuning) {
  const cv::Size size = set.contributions[light].size();
  OtherLights others{cv::Mat(size, CV_32FC3, cv::Scalar::all(0)), {}, {}};
  cv::Mat seen(size, CV_32F, cv::Scalar(0));
  for (size_t j = 0; j < set.contributions.size(); ++j) {
    if (j == light) continue;
    others.rgb += set.contributions[j];
    seen = cv::max(seen, visibilities[j]);
  }
  others.grey = greyOf(others.rgb);
  cv::Mat reached = seen > tuning.seen;
  cv::erode(reached, reached, {}, {-1, -1}, rim, cv::BORDER_CONSTANT, cv::Scalar(255));
  others.known = (others.grey > tuning.dark) & reached;
  return others;
}

cv::Mat lightsAround(const SetEvidence& set, const std::vector<cv::Mat>& visibilities, size_t light,
                     const cv::Mat& litSurfaces, const OtherLightsTuning& tuning) {
  const double wide = tuning.around * referenceUnit(litSurfaces);
  const cv::Mat lit = shrunk(litSurfaces, sizeDivided(litSurfaces.size(), wide / kSmoothPixels));
  const double reach = tuning.around * referenceUnit(lit);
  const auto around = [&](const cv::Mat& x) {
    cv::Mat mean;
    cv::GaussianBlur(lit.mul(x), mean, {}, reach, 0, cv::BORDER_REPLICATE);
    return mean;
  };
  const cv::Mat count = around(cv::Mat(lit.size(), CV_32F, cv::Scalar(1)));
  const cv::Size full = set.contributions[light].size();
  cv::Mat sum(full, CV_32FC3, cv::Scalar::all(0));
  cv::Mat all(lit.size(), CV_32F, cv::Scalar(0)), some = all.clone();  // grey, around
  for (size_t j = 0; j < set.contributions.size(); ++j) {
    if (j == light) continue;
    const cv::Mat share = (around(shrunk(visibilities[j], lit.size())) + kFew) / (count + kFew);
    const cv::Mat grey = shrunk(greyOf(set.contributions[j]), lit.size());
    sum += set.contributions[j].mul(spread(grown(share, full)));
    all += around(grey);
    some += around(grey.mul(share));
  }
  return sum.mul(spread(grown((all + kFew) / (some + kFew), full)));
}

cv::Mat OtherLights::ratioOf(const cv::Mat& own, const cv::Mat& mask, cv::Size size) const {
  cv::Mat ratio;
  cv::divide(shrunk(own.mul(mask), size), cv::max(shrunk(grey.mul(mask), size), 1e-6), ratio);
  return ratio;
}

}  // namespace swaplight
