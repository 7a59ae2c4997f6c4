#include "core/shadow/odds/umbra_network.h"

#include <algorithm>
#include <cmath>
#include <opencv2/dnn.hpp>

#include "core/base/parallel.h"
#include "core/shadow/odds/umbra_network_file.h"

namespace swaplight {
namespace {

enum Told { kUmbraScore, kPenumbraScore, kLitScore, kVisibleScore, kScores };

constexpr float kMostTold = 4.5F;  // a log: less than what half the word of a person's mark weighs
constexpr int kStep = 32;          // pixels: its smallest picture has one for so many

float logSum(float a, float b) {
  return std::max(a, b) + std::log1p(std::exp(-std::abs(a - b)));
}

float oddsOf(float one, float another, float third) {
  return std::clamp(one - logSum(another, third), -kMostTold, kMostTold);
}

int wholeSteps(int pixels) {
  return (pixels + kStep - 1) / kStep * kStep;
}

// The pictures as the network takes them: one after the other, their last pixels repeated to whole steps.
cv::Mat blobOf(const std::vector<cv::Mat>& evidence) {
  const cv::Size size = evidence.front().size();
  const int sizes[] = {1, static_cast<int>(evidence.size()), wholeSteps(size.height), wholeSteps(size.width)};
  cv::Mat blob(4, sizes, CV_32F);
  for (int i = 0; i < sizes[1]; ++i) {
    cv::Mat plane(sizes[2], sizes[3], CV_32F, blob.ptr<float>(0, i));
    cv::copyMakeBorder(evidence[static_cast<size_t>(i)], plane, 0, sizes[2] - size.height, 0,
                       sizes[3] - size.width, cv::BORDER_REPLICATE);
  }
  return blob;
}

}  // namespace

LightOdds weighUmbra(const std::vector<cv::Mat>& evidence) {
  const cv::Size size = evidence.front().size();
  const std::span<const char> file = umbraNetworkFile();
  cv::dnn::Net network =
      cv::dnn::readNetFromONNX(file.data(), file.size());  // one cannot be shared by threads
  network.setInput(blobOf(evidence));
  const cv::Mat scores = network.forward();
  CV_Assert(scores.dims == 4 && scores.size[1] == kScores);
  LightOdds odds{cv::Mat(size, CV_32F), cv::Mat(size, CV_32F), cv::Mat(size, CV_32F)};
  parallelRows(size.height, 16, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const auto row = [&](Told told) { return scores.ptr<float>(0, told, y); };
      const float *umbra = row(kUmbraScore), *penumbra = row(kPenumbraScore), *lit = row(kLitScore),
                  *visible = row(kVisibleScore);
      for (int x = 0; x < size.width; ++x) {
        odds.umbra.at<float>(y, x) = oddsOf(umbra[x], penumbra[x], lit[x]);
        odds.lit.at<float>(y, x) = oddsOf(lit[x], penumbra[x], umbra[x]);
        odds.visible.at<float>(y, x) = 1 / (1 + std::exp(-visible[x]));
      }
    }
  });
  return odds;
}

}  // namespace swaplight
