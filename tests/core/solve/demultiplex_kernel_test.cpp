#include "core/solve/estimators/demultiplex_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "core/simd/padding.h"
#include "core/solve/estimators/two_lights_kernel.h"
#include "tests/support/processor_levels.h"

namespace swaplight {
namespace {

constexpr int kCount = 53;  // no multiple of the lanes
constexpr size_t kPadded = 64;

std::vector<std::vector<float>> randomPlanes(size_t planes, float lowest, float highest) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> value(lowest, highest);
  std::vector<std::vector<float>> out(planes, std::vector<float>(kPadded));
  for (std::vector<float>& plane : out)
    for (float& v : plane) v = value(random);
  return out;
}

TEST(DemultiplexKernel, IsTheProductWithTheInverseAtEveryLevel) {
  for (const std::pair<int, int>& size : std::initializer_list<std::pair<int, int>>{
           {1, 1}, {2, 2}, {3, 3}, {4, 4}, {8, 8}, {2, 3}, {5, 7}, {16, 32}}) {
    const int lights = size.first;
    const int shots = size.second;
    auto in = randomPlanes(size_t(shots), 0, 1);
    auto out = randomPlanes(size_t(lights), 0, 0);
    std::vector<float> matrix;
    for (int i = 0; i < lights * shots; ++i) matrix.push_back(std::sin(float(i)) * (i % 3 ? 1.F : .5F));
    DemultiplexRun run{lights, shots, kCount, matrix.data()};
    for (int k = 0; k < shots; ++k) run.in[k] = in[size_t(k)].data();
    for (int i = 0; i < lights; ++i) run.out[i] = out[size_t(i)].data();
    test::atEveryLevel([&] {
      for (const bool clamp : {true, false}) {
        bool negative = false;
        SWAPLIGHT_KERNEL(demultiplexRun)(run, clamp ? nullptr : &negative);
        bool expectedNegative = false;
        for (int i = 0; i < lights; ++i)
          for (size_t p = 0; p < kCount; ++p) {
            double sum = 0;
            for (int k = 0; k < shots; ++k) sum += double(matrix[size_t(i * shots + k)]) * in[size_t(k)][p];
            expectedNegative |= sum < -1e-5;
            ASSERT_NEAR(out[size_t(i)][p], clamp ? std::max(sum, 0.0) : sum, 2e-6 * shots);
          }
        if (!clamp && expectedNegative) {
          EXPECT_TRUE(negative);
        }
      }
    });
  }
}

TEST(DemultiplexKernel, SaysThatNothingIsNegativeWhereNothingIs) {
  auto in = randomPlanes(2, 1, 2);
  auto out = randomPlanes(2, 0, 0);
  const float inverse[] = {1, 0, .5F, .25F};
  DemultiplexRun run{2, 2, 48, inverse};
  for (size_t k = 0; k < 2; ++k) run.in[k] = in[k].data(), run.out[k] = out[k].data();
  test::atEveryLevel([&] {
    bool negative = true;
    SWAPLIGHT_KERNEL(demultiplexRun)(run, &negative);
    EXPECT_FALSE(negative);
  });
}

TEST(TwoLightsKernel, IsTheClosedFormAtEveryLevel) {
  const TwoLightColors l{{.9F, .2F, .1F}, {.1F, .3F, .8F}, {.15F, .25F, .85F}, {.8F, .25F, .2F}};
  auto shots = randomPlanes(6, .01F, 1);
  auto lights = randomPlanes(6, 0, 0);
  PixelRun in;
  SolvedRun out;
  in.count = kCount;
  for (size_t i = 0; i < 2; ++i)
    for (size_t c = 0; c < 3; ++c) {
      in.signal[i][c] = shots[i * 3 + c].data();
      out.contribution[i][c] = lights[i * 3 + c].data();
    }
  for (const bool published : {false, true})
    test::atEveryLevel([&] {
      SWAPLIGHT_KERNEL(closedFormRun)(in, out, l, published);
      for (size_t p = 0; p < kCount; ++p) {
        double aa = 0, ab = 0;
        for (size_t c = 0; c < 3; ++c) {
          const double y1 = shots[c][p], y2 = shots[3 + c][p];
          const double slope = y1 * (double(l.c[c]) - l.d[c]) - y2 * (double(l.a[c]) - l.b[c]);
          aa += slope * slope, ab += slope * (y1 * l.d[c] - y2 * l.b[c]);
        }
        const double beta = std::clamp(-ab / aa, 0.0, 1.0);
        for (size_t c = 0; c < 3; ++c) {
          const double g1 = l.b[c] + beta * (double(l.a[c]) - l.b[c]),
                       g2 = l.d[c] + beta * (double(l.c[c]) - l.d[c]);
          const double y1 = shots[c][p], y2 = shots[3 + c][p];
          const double rho = published ? y1 / (g1 + .01) : (y1 * g1 + y2 * g2) / (g1 * g1 + g2 * g2);
          ASSERT_NEAR(lights[c][p], beta * rho, 1e-5 * (1 + rho)) << p;
          ASSERT_NEAR(lights[3 + c][p], (1 - beta) * rho, 1e-5 * (1 + rho)) << p;
        }
      }
    });
}

}  // namespace
}  // namespace swaplight
