#include "core/solve/calibration/residual_noise.h"

#include <gtest/gtest.h>

#include "core/color/srgb.h"
#include "core/solve/model/noise_model.h"
#include "core/solve/model/variance_fit.h"
#include "tests/support/synthetic_capture.h"

namespace swaplight {
namespace {

constexpr int kLights = 3;
constexpr NoiseModel kLeast{1e-9F, 0, 0};

struct Taken {
  Capture capture = rotatedCapture(kLights);
  CapturePixels pixels;

  explicit Taken(const SensorNoise& camera, float highlight = 0) {
    capture.noise = camera;
    pixels = photograph(capture, SyntheticSet(kLights, highlight));
  }
  [[nodiscard]] EstimatorContext context(const SensorNoise& noise) const {
    return {lightingFromCapture(capture), noiseModel(noise, pixels, 0)};
  }
  [[nodiscard]] ShotSignal signal(const EstimatorContext& context) const {
    return {pixels, context.lighting, context.noise, {1, 1, 1}};
  }
};

TEST(ResidualNoise, IsThatOfTheCameraWhereEveryPixelIsTexture) {
  constexpr SensorNoise kCamera{.002, 20000};
  const Taken taken(kCamera);
  const SensorNoise spatial = estimateSensorNoise(taken.pixels);
  const EstimatorContext context = taken.context(spatial);
  const NoiseModel found = residualNoise(context, kLeast, taken.signal(context));
  const NoiseModel truth = noiseModel(kCamera, taken.pixels, 0);
  for (const float y : {.1F, .2F, .4F}) {
    EXPECT_GT(context.noise.variance(y), 10 * truth.variance(y)) << "texture is taken for noise";
    EXPECT_GT(found.variance(y), .7F * truth.variance(y)) << y;
    EXPECT_LT(found.variance(y), 2.5F * truth.variance(y)) << y;
  }
}

TEST(ResidualNoise, IsAboutTheSpatialEstimateAtMostAndNeverBelowTheFiles) {
  constexpr SensorNoise kCamera{.002, 20000};
  const Taken taken(kCamera, .3F);  // highlights everywhere
  const EstimatorContext context = taken.context(kCamera);
  const NoiseModel found = residualNoise(context, kLeast, taken.signal(context));
  const NoiseModel least{1e-4F, 0, 0};
  const NoiseModel coarse = residualNoise(context, least, taken.signal(context));
  for (const float y : {.05F, .2F, .5F}) {
    EXPECT_LT(found.variance(y), 2 * context.noise.variance(y));
    EXPECT_GE(coarse.variance(y), least.variance(y));
  }
}

TEST(ResidualNoise, LiesBelowWhatEveryLevelShows) {
  // .25 + 2 y, and at two levels something beside the noise.
  std::vector<VariancePoint> points;
  for (const double y : {.1, .2, .3, .5, .8}) points.push_back({y, .25 + 2 * y});
  points[1].variance *= 3;
  points[3].variance *= 1.5;
  const auto [constant, linear] = varianceBelow(points);
  EXPECT_NEAR(constant, .25, .01);
  EXPECT_NEAR(linear, 2, .05);
  for (const VariancePoint& point : points)
    EXPECT_LE(constant + linear * point.signal, point.variance * 1.001);
  EXPECT_EQ(varianceBelow({})[0], 0);
}

TEST(ResidualNoise, OfTheMisfitOnlyTheModelsErrorIsHeldAgainstAPixel) {
  const NoiseModel own{1e-6F, 2e-5F, 0};
  const NoiseModel calibrated{5e-6F, 1e-5F, 4e-4F};  // its linear part is below the pixels' own
  const NoiseModel none = withModelError(own, calibrated, 0);
  const NoiseModel half = withModelError(own, calibrated, .5F);
  const NoiseModel all = withModelError(own, calibrated, 1);
  EXPECT_EQ(none.variance(.3F), own.variance(.3F));
  EXPECT_FLOAT_EQ(half.constant, 3e-6F);
  EXPECT_FLOAT_EQ(half.square, 2e-4F);
  EXPECT_EQ(all.constant, calibrated.constant);
  EXPECT_EQ(all.linear, own.linear) << "never below what every pixel has";
}

constexpr float kNoPhotonNoise = 1e12F;  // full well

/// The variance that rounding to 8 bits of sRGB makes around a value, by doing it.
double roundingAround(float value) {
  constexpr int kSteps = 10000;
  double squares = 0;
  for (int j = 0; j < kSteps; ++j) {
    const float y = value * (0.95F + 0.1F * (float(j) + 0.5F) / kSteps);
    const float error = linearFromSrgb(std::round(255 * srgbFromLinear(y)) / 255) - y;
    squares += double(error) * error;
  }
  return squares / kSteps;
}

TEST(NoiseModel, RoundingOfSrgbCodesIsNotTakenForLessThanItIs) {
  CapturePixels pixels;
  pixels.quantum = {1 - linearFromSrgb(254.F / 255)};
  pixels.rounding = roundingErrors([](float code) { return linearFromSrgb(code); }, 1.F / 255);
  const NoiseModel model = noiseModel({0, kNoPhotonNoise}, pixels, 0);
  for (const float value : {.03F, .06F, .1F, .2F, .4F, .6F, .9F}) {
    EXPECT_GT(model.variance(value), .97 * roundingAround(value)) << value;
    EXPECT_LT(model.variance(value), 1.6 * roundingAround(value)) << value;
  }
  EXPECT_LT(model.variance(.01F), 2.2 * roundingAround(.01F));
}

TEST(NoiseModel, RoundingIsThatOfTheCurveWhateverItsShoulder) {
  // The last step below white is worth forty times the mean one.
  const auto light = [](float code) { return 0.02F * code / (1.02F - code); };
  CapturePixels pixels;
  pixels.quantum = {light(1) - light(254.F / 255)};
  pixels.rounding = roundingErrors(light, 1.F / 255);
  const NoiseModel model = noiseModel({0, kNoPhotonNoise}, pixels, 0);
  for (const float code : {.25F, .5F, .75F}) {
    const float step = light(code + .5F / 255) - light(code - .5F / 255);
    EXPECT_GT(model.variance(light(code)), .9F * step * step / 12) << code;
  }
  EXPECT_TRUE(roundingErrors([](float code) { return std::min(code, .9F); }, 1.F / 255).empty())
      << "white is flat";
}

TEST(NoiseModel, RoundingOfLinearCodesIsTheSameEverywhere) {
  CapturePixels pixels;
  pixels.quantum = {1.F / 255};
  const NoiseModel model = noiseModel({0, kNoPhotonNoise}, pixels, 0);
  const float rounding = 1.F / (255 * 255 * 12);
  EXPECT_NEAR(model.variance(.01F), rounding, .01 * rounding);
  EXPECT_NEAR(model.variance(.5F), rounding, .01 * rounding);
}

}  // namespace
}  // namespace swaplight
