#include "core/shadow/odds/umbra_evidence.h"

#include <algorithm>
#include <utility>

#include "core/base/check.h"
#include "core/shadow/numeric/shadow_pictures.h"

namespace swaplight {
namespace {

// tests/train/umbra_net.py prepares what it learns from in the same way, with the same numbers.
constexpr float kFloor = 5e-4F;     // of the brightest: what is darker is all alike
constexpr float kMostColour = 2;    // log
constexpr double kBrightest = .99;  // share of the pixels that are not above

float brightestOf(const cv::Mat& grey) {
  return std::max(percentile(grey, kBrightest), 1e-9F);
}

cv::Mat logOver(const cv::Mat& x, float brightest, float floor = kFloor) {
  cv::Mat out = cv::max(x, 0) / brightest + floor;
  cv::log(out, out);
  return out;
}

// The logs of red and of blue over green.
void addColour(const cv::Mat& rgb, float brightest, std::vector<cv::Mat>& evidence) {
  cv::Mat channels[3];
  cv::split(rgb, channels);
  for (cv::Mat& channel : channels) channel = logOver(channel, brightest, 2 * kFloor);
  for (const int c : {0, 2})
    evidence.emplace_back(cv::min(cv::max(channels[c] - channels[1], -kMostColour), kMostColour));
}

SmallSet setOf(std::vector<cv::Mat> rgb) {
  SWAPLIGHT_CHECK(!rgb.empty());
  SmallSet set;
  set.rgb = std::move(rgb);
  set.totalRgb = cv::Mat::zeros(set.rgb.front().size(), CV_32FC3);
  for (const cv::Mat& each : set.rgb) {
    set.grey.push_back(greyOf(each));
    set.brightest.push_back(brightestOf(set.grey.back()));
    set.totalRgb += each;
  }
  set.total = greyOf(set.totalRgb);
  set.totalBrightest = brightestOf(set.total);
  return set;
}

}  // namespace

SmallSet smallSetOf(std::span<const Image> contributions, cv::Size size) {
  std::vector<cv::Mat> rgb;
  for (const Image& contribution : contributions) {
    cv::Mat channels[3];
    for (int c = 0; c < 3; ++c) channels[c] = shrunk(planeOf(contribution, c), size);
    cv::merge(channels, 3, rgb.emplace_back());
  }
  return setOf(std::move(rgb));
}

SmallSet smallerSetOf(const SmallSet& set, cv::Size size) {
  std::vector<cv::Mat> rgb;
  for (const cv::Mat& each : set.rgb) rgb.push_back(shrunk(each, size));
  return setOf(std::move(rgb));
}

std::vector<cv::Mat> umbraEvidence(const SmallSet& set, size_t light) {
  const float own = set.brightest[light];
  const float all = set.totalBrightest;
  const cv::Mat level = logOver(set.grey[light], own);
  const cv::Mat others = logOver(set.total - set.grey[light], all);
  // The scales and offsets bring each to about -1 to 1: that is how the network was taught.
  std::vector<cv::Mat> evidence = {.5 * level + 1, .5 * others + 1, .5 * (level - logOver(set.total, all))};
  addColour(set.rgb[light], own, evidence);
  addColour(set.totalRgb - set.rgb[light], all, evidence);
  cv::Mat mean = cv::Mat::zeros(level.size(), CV_32F), highest, lowest;
  for (size_t i = 0; i < set.grey.size(); ++i) {
    if (i == light) continue;
    const cv::Mat other = logOver(set.grey[i], set.brightest[i]);
    mean += other / static_cast<double>(set.grey.size() - 1);
    highest = highest.empty() ? other : cv::Mat(cv::max(highest, other));
    lowest = lowest.empty() ? other : cv::Mat(cv::min(lowest, other));
  }
  if (highest.empty()) highest = lowest = mean;
  evidence.insert(evidence.end(), {.5 * mean + 1, .5 * highest + .5, .5 * lowest + 1.5});
  return evidence;
}

}  // namespace swaplight
