#include "core/shadow/odds/umbra_network.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/shadow/odds/umbra_weights.h"
#include "core/simd/simd.h"

namespace swaplight {
namespace {

using namespace umbra_weights;

enum Class { kUmbraClass, kPenumbraClass, kLitClass, kClasses };

constexpr float kMostTold = 12;  // a log: the weights know no more than that

constexpr size_t kTile = 16;  // pixels weighed at once: a register, or a few

// What each class gets of `count` pixels (at most kTile) that begin at `first`.
SWAPLIGHT_SIMD(void, weighTile,
               (const float* const* features, size_t first, size_t count, float (&scores)[kClasses][kTile]),
               (features, first, count, scores)) {
  float value[kFeatures][kTile] = {};
  for (size_t f = 0; f < kFeatures; ++f) {
    for (size_t l = 0; l < count; ++l) value[f][l] = features[f][first + l];
    for (size_t l = 0; l < kTile; ++l) {
      value[f][l] = value[f][l] > kLeast[f] ? value[f][l] : kLeast[f];
      value[f][l] = value[f][l] < kMost[f] ? value[f][l] : kMost[f];
    }
  }
  for (size_t k = 0; k < kClasses; ++k)
    for (size_t l = 0; l < kTile; ++l) scores[k][l] = kOutputBias[k];
  for (size_t j = 0; j < kHidden; ++j) {
    float hidden[kTile];
    for (size_t l = 0; l < kTile; ++l) hidden[l] = kHiddenBias[j];
    for (size_t f = 0; f < kFeatures; ++f)
      for (size_t l = 0; l < kTile; ++l) hidden[l] += value[f][l] * kHiddenWeights[f][j];
    for (size_t k = 0; k < kClasses; ++k)
      for (size_t l = 0; l < kTile; ++l)
        scores[k][l] += kOutputWeights[j][k] * (hidden[l] > 0 ? hidden[l] : 0);
  }
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
    const float* rows[kFeatures];
    float score[kClasses][kTile];
    const auto told = [](float one, float another, float third) {
      return std::clamp(one - logSum(another, third), -kMostTold, kMostTold);
    };
    for (int y = begin; y < end; ++y) {
      for (size_t f = 0; f < kFeatures; ++f) rows[f] = features[f].ptr<float>(y);
      const auto width = size_t(size.width);
      for (size_t x = 0; x < width; x += kTile) {
        const size_t count = std::min(kTile, width - x);
        weighTile(rows, x, count, score);
        for (size_t l = 0; l < count; ++l) {
          const float umbra = score[kUmbraClass][l], penumbra = score[kPenumbraClass][l],
                      lit = score[kLitClass][l];
          odds.umbra.ptr<float>(y)[x + l] = told(umbra, penumbra, lit);
          odds.lit.ptr<float>(y)[x + l] = told(lit, penumbra, umbra);
        }
      }
    }
  });
  return odds;
}

}  // namespace swaplight
