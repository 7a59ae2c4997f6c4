// The Poisson equation of a whole picture (core/linear/grid_poisson.h) beside the cosine transform (OpenCV's,
// in double precision, as it was solved before), by turns: milliseconds by the clock, the quickest of each,
// and how far the two are apart. usage: poisson_bench [TURNS]     (5)
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <opencv2/core.hpp>
#include <random>
#include <span>
#include <utility>

#include "core/linear/grid_poisson.h"

namespace {

cv::Mat noisyPicture(cv::Size size) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise;
  cv::Mat picture(size, CV_64F);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      picture.at<double>(y, x) = .1 * noise(random) + std::cos(3. * x / size.width + 2. * y / size.height);
  return picture;
}

cv::Mat differences(const cv::Mat& picture) {
  cv::Mat sums(picture.size(), CV_64F, cv::Scalar(0));
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x)
      for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}}) {
        if (x + dx >= picture.cols || y + dy >= picture.rows) continue;
        const double apart = picture.at<double>(y, x) - picture.at<double>(y + dy, x + dx);
        sums.at<double>(y, x) += apart;
        sums.at<double>(y + dy, x + dx) -= apart;
      }
  return sums;
}

void byCosines(cv::Mat& d) {
  cv::dct(d, d);
  for (int y = 0; y < d.rows; ++y)
    for (int x = 0; x < d.cols; ++x) {
      const double scale =
          4 - 2 * std::cos(std::numbers::pi * y / d.rows) - 2 * std::cos(std::numbers::pi * x / d.cols);
      d.at<double>(y, x) = x + y > 0 ? d.at<double>(y, x) / scale : 0;
    }
  cv::idct(d, d);
}

template <typename Work>
void keepQuickest(double& quickest, const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
  quickest = std::min(quickest, taken.count());
}

}  // namespace

int main(int argc, char** argv) {
  const int turns = argc > 1 ? std::max(std::atoi(argv[1]), 1) : 5;
  fmt::print("| size | cosines | multigrid | apart, of the solution |\n|---|---|---|---|\n");
  for (const cv::Size size : {cv::Size(1280, 720), cv::Size(1920, 1080), cv::Size(3840, 2160)}) {
    const cv::Mat wanted = differences(noisyPicture(size));
    cv::Mat given, cosines, solution(size, CV_32F);
    wanted.convertTo(given, CV_32F);
    double slow = HUGE_VAL, fast = HUGE_VAL;
    for (int turn = 0; turn < turns; ++turn) {
      wanted.copyTo(cosines);
      keepQuickest(slow, [&] { byCosines(cosines); });
      keepQuickest(fast, [&] {
        swaplight::solvePoisson(size.width, size.height, std::span(given.ptr<float>(), given.total()),
                                std::span(solution.ptr<float>(), solution.total()));
      });
    }
    cosines.convertTo(cosines, CV_32F);
    fmt::print("| {} x {} | {:.0f} | {:.0f} | {:.1e} |\n", size.width, size.height, slow, fast,
               cv::norm(cosines, solution) / cv::norm(cosines));
  }
}
