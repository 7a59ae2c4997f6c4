#include "core/solve/calibration/edge_noise.h"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/solve/model/chi_square.h"

namespace swaplight {
namespace {

constexpr int kWindow = 5;  // pixels; also what a gradient and its mean reach beyond a pixel
constexpr int kReach = kWindow / 2 + 1;
constexpr int kBlock = 32;  // a sample's blocks, kBlocks across and down
constexpr int kBlocks = 12;

/// e of an area.
cv::Mat edgeStrength(const CapturePixels& pixels, const NoiseModel& noise, const cv::Rect& area) {
  const Image& first = pixels.shots.front();
  const cv::Rect wide =
      cv::Rect(area.x - kReach, area.y - kReach, area.width + 2 * kReach, area.height + 2 * kReach) &
      cv::Rect(0, 0, first.width(), first.height());
  cv::Mat mean(wide.size(), CV_32F, 0.0F);
  for (const Image& shot : pixels.shots)
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < wide.height; ++y) {
        const float* from = shot.view().row(c, wide.y + y) + wide.x;
        auto* to = mean.ptr<float>(y);
        for (int x = 0; x < wide.width; ++x) to[x] += from[x] - from[x] == 0 ? from[x] : 0;  // finite
      }
  const float values = float(3 * pixels.shots.size());
  mean *= 1 / values;
  cv::Mat across, down;
  cv::Sobel(mean, across, CV_32F, 1, 0, 1, 0.5, 0, cv::BORDER_REPLICATE);
  cv::Sobel(mean, down, CV_32F, 0, 1, 1, 0.5, 0, cv::BORDER_REPLICATE);
  cv::Mat squared = across.mul(across) + down.mul(down);
  cv::blur(squared, squared, {kWindow, kWindow}, {-1, -1}, cv::BORDER_REPLICATE);
  for (int y = 0; y < wide.height; ++y)
    for (int x = 0; x < wide.width; ++x) {
      // Noise has gradients of its own.
      float& e = squared.at<float>(y, x);
      e = std::max(e / noise.variance(mean.at<float>(y, x)) - 1 / values, 0.0F);
    }
  return squared({area.x - wide.x, area.y - wide.y, area.width, area.height});
}

float medianMisfit(std::vector<std::pair<float, float>>& sample, size_t first, size_t last) {
  const auto middle = sample.begin() + long((first + last) / 2);
  std::nth_element(sample.begin() + long(first), middle, sample.begin() + long(last),
                   [](const auto& a, const auto& b) { return a.second < b.second; });
  return middle->second;
}

}  // namespace

float squaredEdgeShift(const ShotSignal& signal, const NoiseModel& noise, ImageView misfit, int freedom,
                       const EdgeNoiseTuning& tuning) {
  const int width = misfit.width;
  const int height = misfit.height;
  using Sample = std::vector<std::pair<float, float>>;  // edge strength, misfit
  std::array<Sample, kBlocks> ofRow;
  parallelEach(kBlocks, [&](int row) {
    for (int column = 0; column < kBlocks; ++column) {
      const cv::Rect area = cv::Rect(column * width / kBlocks, row * height / kBlocks, kBlock, kBlock) &
                            cv::Rect(0, 0, std::max(width * (column + 1) / kBlocks, 1),
                                     std::max(height * (row + 1) / kBlocks, 1));
      if (area.empty()) continue;
      const cv::Mat strength = edgeStrength(signal.pixels(), noise, area);
      for (int y = 0; y < area.height; ++y)
        for (int x = 0; x < area.width; ++x) {
          const size_t p = size_t(area.y + y) * size_t(width) + size_t(area.x + x);
          if (signal.flagged(p, 1)) continue;
          ofRow[size_t(row)].emplace_back(strength.at<float>(y, x), misfit.row(0, area.y + y)[area.x + x]);
        }
    }
  });
  Sample sample;
  for (const Sample& some : ofRow) sample.insert(sample.end(), some.begin(), some.end());
  if (sample.size() < size_t(tuning.minSample)) return 0;
  // The flatter half first, the strongest tenth last, and the middle of that in its place.
  const size_t strong = sample.size() * 9 / 10;
  const auto middle = sample.begin() + long((strong + sample.size()) / 2);
  const auto tenth = sample.begin() + long(strong);
  std::nth_element(sample.begin(), tenth, sample.end());
  std::nth_element(tenth, middle, sample.end());
  std::nth_element(sample.begin(), sample.begin() + long(sample.size() / 2), tenth);
  const float typical = middle->first;
  const float flat = medianMisfit(sample, 0, sample.size() / 2);
  const float edges = medianMisfit(sample, strong, sample.size());
  const float expected = float(medianChiSquare(std::max(freedom, 1)));
  if (flat > tuning.maxFlatMisfit * expected) return 0;
  if (typical <= 0 || !(edges > tuning.minMisfitRatio * flat)) return 0;
  const float squared = (edges / std::clamp(flat, 1e-3F, expected) - 1) / typical;
  return squared > tuning.minShift2 ? tuning.tailFactor * squared : 0;
}

void edgeNoiseFactor(const ShotSignal& signal, const NoiseModel& noise, float squaredShift,
                     ImageSpan factor) {
  parallelRows(factor.height, 64, [&](int begin, int end) {
    const cv::Mat strength = edgeStrength(signal.pixels(), noise, {0, begin, factor.width, end - begin});
    for (int y = begin; y < end; ++y) {
      const auto* from = strength.ptr<float>(y - begin);
      float* to = factor.row(0, y);
      for (int x = 0; x < factor.width; ++x) to[x] = 1 + squaredShift * from[x];
    }
  });
}

}  // namespace swaplight
