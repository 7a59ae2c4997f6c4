#include "core/solve/even_lamps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

using testing::HasSubstr;

/// A colour that drifts by 10 % from the middle to the edges.
SmoothField drift(double x, double y) {
  std::array<std::array<double, SmoothField::kTerms>, 3> terms{};
  terms[0][1] = .1 * x, terms[2][1] = -.1 * x;
  terms[0][2] = -.1 * y, terms[1][2] = .1 * y;
  return SmoothField(terms);
}

/// Where another gel has another field.
FlatFields fieldsOf(const Capture& capture) {
  FlatFields fields;
  for (size_t k = 0; k < capture.shots.size(); ++k) {
    auto& lamps = fields.lamps.emplace_back();
    for (size_t i = 0; i < capture.lights.size(); ++i)
      lamps.emplace_back(drift(i == 0 ? 1 : -.7, k == 0 ? .6 : -.6));
  }
  return fields;
}

Capture noisyCapture(int lights) {
  Capture capture = rotatedCapture(lights);
  capture.noise = SensorNoise{.002, 20000};
  return capture;
}

/// Shots of the lamps as they are, with the noise of photograph().
CapturePixels unevenShots(const Capture& capture, const SyntheticSet& set, const FlatFields& fields) {
  CapturePixels pixels = photograph(capture, set);
  std::vector<float> factor(static_cast<size_t>(set.width));
  for (size_t k = 0; k < capture.shots.size(); ++k)
    for (size_t i = 0; i < set.truth.size(); ++i)
      for (int c = 0; c < 3; ++c)
        for (int y = 0; y < set.height; ++y) {
          fields.lamps[k][i]->row(c, y, set.width, set.height, factor.data());
          for (int x = 0; x < set.width; ++x)
            pixels.shots[k].span().at(c, x, y) += (*capture.shots[k].lightColors[i])[c] *
                                                  (factor[size_t(x)] - 1) * set.truth[i].view().at(c, x, y);
        }
  return pixels;
}

double errorOf(const SolvedSet& set, const SyntheticSet& truth) {
  double error = 0, signal = 0;
  for (size_t i = 0; i < truth.truth.size(); ++i)
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < truth.truth[i].pixelCount(); ++p) {
        error += std::pow(set.contributions[i].plane(c)[p] - truth.truth[i].plane(c)[p], 2);
        signal += std::pow(truth.truth[i].plane(c)[p], 2);
      }
  return std::sqrt(error / signal);
}

TEST(SolveUneven, IsAsGoodAsWithEvenLamps) {
  for (const int lights : {2, 3})
    for (const float highlight : {0.F, .2F}) {
      const Capture capture = noisyCapture(lights);
      const SyntheticSet truth(lights, highlight);
      const FlatFields fields = fieldsOf(capture);
      const double clean = errorOf(solve(capture, photograph(capture, truth), {}), truth);
      const CapturePixels uneven = unevenShots(capture, truth, fields);
      const double asIs = errorOf(solve(capture, uneven, {}), truth);
      const SolvedSet evened = solveUneven(capture, uneven, fields, {});
      EXPECT_GT(asIs, 1.5 * clean) << lights;
      EXPECT_LT(errorOf(evened, truth), 1.2 * clean) << lights;  // BALANCE's target: within 20 %
      EXPECT_THAT(evened.report->message, HasSubstr("evened"));
    }
}

TEST(SolveUneven, WithoutFieldsIsSolve) {
  const Capture capture = noisyCapture(2);
  const SyntheticSet truth(2, 0);
  const CapturePixels pixels = photograph(capture, truth);
  const SolvedSet one = solve(capture, pixels, {}), other = solveUneven(capture, pixels, {}, {});
  for (size_t p = 0; p < truth.truth[0].pixelCount(); ++p)
    ASSERT_EQ(one.contributions[0].plane(1)[p], other.contributions[0].plane(1)[p]);
}

TEST(SolveUneven, GivesBackWhatTheLensTakes) {
  const Capture capture = noisyCapture(2);
  const SyntheticSet truth(2, 0);
  CapturePixels pixels = photograph(capture, truth);
  std::array<std::array<double, SmoothField::kTerms>, 3> terms{};
  for (auto& channel : terms) channel[3] = channel[5] = -.5;  // x^2, y^2
  FlatFields fields;
  fields.lens = SmoothField(terms);
  std::vector<float> factor(static_cast<size_t>(truth.width));
  for (Image& shot : pixels.shots)
    for (int c = 0; c < 3; ++c)
      for (int y = 0; y < truth.height; ++y) {
        fields.lens->row(c, y, truth.width, truth.height, factor.data());
        for (int x = 0; x < truth.width; ++x) shot.span().at(c, x, y) *= factor[size_t(x)];
      }
  const double clean = errorOf(solve(capture, photograph(capture, truth), {}), truth);
  EXPECT_GT(errorOf(solve(capture, pixels, {}), truth), .2);
  EXPECT_LT(errorOf(solveUneven(capture, pixels, fields, {}), truth), 1.2 * clean);
}

/// Returns how many values are saturated now.
size_t saturate(CapturePixels& pixels, float full) {
  size_t saturated = 0;
  for (size_t k = 0; k < pixels.shots.size(); ++k) {
    pixels.clipLevel[k] = full;
    for (int c = 0; c < 3; ++c)
      for (size_t p = 0; p < pixels.shots[k].pixelCount(); ++p)
        if (float& y = pixels.shots[k].plane(c)[p]; y >= full) y = full, ++saturated;
  }
  return saturated;
}

TEST(SolveUneven, KeepsSaturatedPixelsSaturated) {
  Capture capture = noisyCapture(2);
  const SyntheticSet truth(2, 0);
  const FlatFields fields = fieldsOf(capture);
  CapturePixels pixels = unevenShots(capture, truth, fields);
  ASSERT_GT(saturate(pixels, .25F), 100U);
  const SolvedSet before = solve(capture, pixels, {}), after = solveUneven(capture, pixels, fields, {});
  EXPECT_EQ(before.report->clipped, after.report->clipped);
  EXPECT_LE(errorOf(after, truth), errorOf(before, truth));
}

/// The lights together, of the pixels where a shot is saturated.
double lightOfSaturated(const SolvedSet& set, const CapturePixels& pixels) {
  double sum = 0;
  for (size_t p = 0; p < pixels.shots[0].pixelCount(); ++p) {
    bool saturated = false;
    for (size_t k = 0; k < pixels.shots.size(); ++k)
      for (int c = 0; c < 3; ++c) saturated |= pixels.shots[k].plane(c)[p] >= pixels.clipLevel[k];
    for (int c = 0; saturated && c < 3; ++c)
      for (const Image& light : set.contributions) sum += double(light.plane(c)[p]);
  }
  return sum;
}

TEST(SolveUneven, MakesSaturatedPixelsNoBrighterThanTheyAreSaidToBe) {
  const Capture capture = noisyCapture(2);
  const SyntheticSet truth(2, 0);
  const FlatFields fields = fieldsOf(capture);
  CapturePixels even = photograph(capture, truth), uneven = unevenShots(capture, truth, fields);
  const SolvedSet evenWhole = solve(capture, even, {}), whole = solveUneven(capture, uneven, fields, {});
  ASSERT_GT(saturate(even, .3F), 1000U);
  saturate(uneven, .3F);
  const SolvedSet evened = solveUneven(capture, uneven, fields, {});
  EXPECT_NEAR(lightOfSaturated(evened, uneven) / lightOfSaturated(whole, uneven),
              lightOfSaturated(solve(capture, even, {}), even) / lightOfSaturated(evenWhole, even), .01);
}

}  // namespace
}  // namespace swaplight
