#include "core/shadow/odds/umbra_network.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/shadow/odds/umbra_weights.h"

namespace swaplight {
namespace {

using namespace umbra_weights;

enum Class { kUmbraClass, kPenumbraClass, kLitClass, kClasses };

constexpr float kMostTold = 12;  // a log: the weights know no more than that

using Hidden = std::array<float, kHidden>;

std::array<float, kClasses> scoresOf(const Hidden& hidden) {
  std::array<float, kClasses> scores = kOutputBias;
  for (size_t j = 0; j < kHidden; ++j)
    for (size_t k = 0; k < kClasses; ++k) scores[k] += kOutputWeights[j][k] * std::max(hidden[j], 0.f);
  return scores;
}

float logSum(float a, float b) {
  return std::max(a, b) + std::log1p(std::exp(-std::abs(a - b)));
}

}  // namespace

LightOdds weighUmbra(const std::vector<cv::Mat>& features) {
  CV_Assert(features.size() == kFeatures);
  const cv::Size size = features.front().size();
  LightOdds odds{cv::Mat(size, CV_32F), cv::Mat(size, CV_32F)};
  parallelRows(size.height, 16, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < size.width; ++x) {
        Hidden hidden = kHiddenBias;
        for (size_t f = 0; f < kFeatures; ++f) {
          const float value = std::clamp(features[f].at<float>(y, x), kLeast[f], kMost[f]);
          for (size_t j = 0; j < kHidden; ++j) hidden[j] += value * kHiddenWeights[f][j];
        }
        const auto score = scoresOf(hidden);
        const auto clamped = [](float value) { return std::clamp(value, -kMostTold, kMostTold); };
        odds.umbra.at<float>(y, x) =
            clamped(score[kUmbraClass] - logSum(score[kPenumbraClass], score[kLitClass]));
        odds.lit.at<float>(y, x) =
            clamped(score[kLitClass] - logSum(score[kPenumbraClass], score[kUmbraClass]));
      }
  });
  return odds;
}

}  // namespace swaplight
