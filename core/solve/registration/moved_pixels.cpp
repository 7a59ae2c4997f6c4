#include "core/solve/registration/moved_pixels.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/solve/estimators/demultiplex.h"
#include "core/solve/estimators/matte_fit.h"
#include "core/solve/model/pixel_batch.h"
#include "core/solve/model/shot_signal.h"

namespace swaplight {
namespace {

/// Solves the marked pixels with an estimator, and hands each answer on: use(pixel, scratch, index).
template <typename Use>
void eachMarked(const cv::Mat& marked, const ShotSignal& signal, const EstimatorContext& context,
                const Estimator& estimator, bool masks, const Use& use) {
  const uint8_t* mark = marked.ptr<uint8_t>();
  const int runs = int((signal.pixelCount() + kRun - 1) / kRun);
  parallelRows(runs, 4, [&](int begin, int end) {
    std::vector<float> scratch;
    for (int r = begin; r < end; ++r) {
      const size_t first = size_t(r) * kRun;
      const int count = int(std::min<size_t>(kRun, signal.pixelCount() - first));
      std::vector<int> index;
      for (int p = 0; p < count; ++p)
        if (mark[first + size_t(p)]) index.push_back(p);
      if (index.empty()) continue;
      PixelRun in;
      signal.run(first, count, masks, scratch, in);
      const PixelBatch batch(in, std::move(index), context.lighting.shots, context.lighting.lights);
      estimator.estimate(batch.in(), batch.out());
      for (size_t j = 0; j < batch.index().size(); ++j) use(first + size_t(batch.index()[j]), batch.out(), j);
    }
  });
}

void dropSmall(cv::Mat& marked, int smallestArea) {
  cv::Mat label, statistics, centre;
  const int count = cv::connectedComponentsWithStats(marked, label, statistics, centre, 8);
  std::vector<uint8_t> keep(size_t(count), 0);
  for (int j = 1; j < count; ++j)
    keep[size_t(j)] = statistics.at<int>(j, cv::CC_STAT_AREA) >= smallestArea ? 255 : 0;
  for (int y = 0; y < marked.rows; ++y)
    for (int x = 0; x < marked.cols; ++x) marked.at<uint8_t>(y, x) = keep[size_t(label.at<int>(y, x))];
}

}  // namespace

size_t markMoved(const EstimatorContext& context, const ShotSignal& signal, SolvedSet& set,
                 const MotionTuning& tuning) {
  if (context.lighting.shots < context.lighting.lights || context.lighting.lights < 2) return 0;
  const int width = set.quality.width();
  const int height = set.quality.height();
  const float* residual = set.quality.plane(kResidual);
  cv::Mat misfit(height, width, CV_8U);
  size_t suspects = 0;
  for (size_t p = 0; p < signal.pixelCount(); ++p) {
    const bool usable = signal.flags().empty() || signal.flags()[p] == 0;
    const bool suspect = usable && residual[p] > tuning.minMisfit;
    misfit.ptr<uint8_t>()[p] = suspect ? 255 : 0;
    suspects += suspect;
  }
  if (suspects < size_t(tuning.smallestArea)) return 0;

  EstimatorContext lenient = context;
  lenient.noise.square = std::max(lenient.noise.square, tuning.colorError * tuning.colorError);
  const Demultiplex possible(lenient, Demultiplex::Bound::LeastSquares);
  const float freedom = float(std::max(3 * (context.lighting.shots - context.lighting.lights), 1));
  const float limit = tuning.impossible / std::sqrt(freedom) + (freedom > 1 ? 1 : 0);
  cv::Mat witness = cv::Mat::zeros(height, width, CV_8U);
  std::atomic<int> witnesses = 0;
  eachMarked(misfit, signal, context, possible, false, [&](size_t p, const SolvedRun& run, size_t j) {
    if (run.residual[j] > limit) witness.ptr<uint8_t>()[p] = 255, ++witnesses;
  });
  if (witnesses < tuning.smallestArea / 4) return 0;

  // The misfit around dense witnesses, holes closed, specks dropped.
  cv::Mat density, marked;
  cv::blur(witness, density, {tuning.window, tuning.window});
  const cv::Mat square = cv::getStructuringElement(cv::MORPH_RECT, {3, 3});
  const cv::Mat disc = cv::getStructuringElement(cv::MORPH_ELLIPSE, {tuning.window, tuning.window});
  marked = density > 255 * tuning.minDensity;
  cv::morphologyEx(marked, marked, cv::MORPH_OPEN, square);
  cv::dilate(marked, marked, disc);
  marked &= misfit;
  cv::morphologyEx(marked, marked, cv::MORPH_CLOSE, disc);
  cv::morphologyEx(marked, marked, cv::MORPH_OPEN, square);
  dropSmall(marked, tuning.smallestArea);
  const auto count = size_t(cv::countNonZero(marked));
  if (count == 0) return 0;

  eachMarked(marked, signal, context, Lambert(context), true, [&](size_t p, const SolvedRun& run, size_t j) {
    for (int i = 0; i < context.lighting.lights; ++i)
      for (int c = 0; c < 3; ++c) set.contributions[size_t(i)].plane(c)[p] = run.contribution[i][c][j];
    set.quality.plane(kResidual)[p] = run.residual[j];
    set.quality.plane(kSigma)[p] = run.sigma[j];
    set.quality.plane(kModel)[p] = 0;
    set.quality.plane(kFlags)[p] = kMoved;
  });
  return count;
}

}  // namespace swaplight
