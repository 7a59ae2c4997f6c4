#include "core/linear/grid_poisson.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "core/base/parallel.h"

namespace swaplight {
namespace {

struct Size {
  int width;
  int height;
};

// What Poisson's equation says of a picture: the sum of (pixel - neighbour).
std::vector<double> differences(Size size, const std::vector<float>& picture) {
  std::vector<double> sums(picture.size(), 0);
  const auto link = [&](size_t a, size_t b) {
    const double apart = double(picture[a]) - double(picture[b]);
    sums[a] += apart;
    sums[b] -= apart;
  };
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const auto width = static_cast<size_t>(size.width);
      const size_t pixel = static_cast<size_t>(y) * width + static_cast<size_t>(x);
      if (x + 1 < size.width) link(pixel, pixel + 1);
      if (y + 1 < size.height) link(pixel, pixel + width);
    }
  return sums;
}

double rms(const std::vector<double>& values) {
  const double squares = std::inner_product(values.begin(), values.end(), values.begin(), 0.);
  return std::sqrt(squares / static_cast<double>(values.size()));
}

// Noise, which no smoothing leaves, and waves as long as the picture.
std::vector<float> noiseAndWaves(Size size) {
  std::mt19937 random(7);
  std::normal_distribution<float> noise;
  std::vector<float> picture;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      picture.push_back(noise(random) + 20 * std::cos(3 * float(x) / float(size.width)) +
                        10 * std::sin(2 * float(y) / float(size.height)));
  return picture;
}

class Poisson : public testing::TestWithParam<Size> {};

TEST_P(Poisson, FindsThePictureWithTheseDifferences) {
  const Size size = GetParam();
  const std::vector<float> picture = noiseAndWaves(size);
  const std::vector<double> wanted = differences(size, picture);
  std::vector<float> solution(picture.size(), NAN);
  solvePoisson(size.width, size.height, std::vector<float>(wanted.begin(), wanted.end()), solution);

  const double mean = std::accumulate(picture.begin(), picture.end(), 0.) / double(picture.size());
  std::vector<double> error, centred, left = differences(size, solution);
  for (size_t i = 0; i < picture.size(); ++i) {
    centred.push_back(double(picture[i]) - mean);
    error.push_back(double(solution[i]) - centred.back());
    left[i] -= wanted[i];
  }
  EXPECT_LE(rms(error), 3e-3 * rms(centred));
  EXPECT_LE(rms(left), 1e-3 * rms(wanted));
  EXPECT_NEAR(std::accumulate(solution.begin(), solution.end(), 0.) / double(solution.size()), 0, 1e-5);
}

// 49: halved once. 641 x 481 and 257 x 385: odd at every halving. 2 x 300, 500 x 2: narrow.
INSTANTIATE_TEST_SUITE_P(Sizes, Poisson,
                         testing::Values(Size{1, 1}, Size{2, 1}, Size{1, 40}, Size{2, 300}, Size{500, 2},
                                         Size{48, 48}, Size{49, 3}, Size{640, 360}, Size{641, 481},
                                         Size{257, 385}, Size{300, 258}),
                         [](const auto& tested) {
                           return std::to_string(tested.param.width) + "x" +
                                  std::to_string(tested.param.height);
                         });

TEST(Poisson, IsTheSameOnAnyNumberOfThreads) {
  const Size size{331, 517};
  const std::vector<double> wanted = differences(size, noiseAndWaves(size));
  const std::vector<float> given(wanted.begin(), wanted.end());
  std::vector<float> one(given.size()), four(given.size());
  setThreads(1);
  solvePoisson(size.width, size.height, given, one);
  setThreads(4);
  solvePoisson(size.width, size.height, given, four);
  setThreads(0);
  EXPECT_EQ(one, four);
}

TEST(Poisson, LeavesAnEvenPictureEven) {
  std::vector<float> solution(200 * 100, 5);
  solvePoisson(200, 100, std::vector<float>(solution.size(), 0), solution);
  EXPECT_EQ(solution, std::vector<float>(solution.size(), 0));
}

}  // namespace
}  // namespace swaplight
